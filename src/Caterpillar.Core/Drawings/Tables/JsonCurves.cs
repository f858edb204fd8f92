namespace Caterpillar.Drawings;

/// <summary>
/// Curves as JSON: <c>[[x,y,z], …]</c> is one curve, a list of such lists is several curves, and <c>{"curves": […], "units": "mm"}</c> is the full form. A
/// curve is a list of points or an object. Polylines have <c>points</c> and <c>closed</c>. NURBS have <c>degree</c>, <c>points</c>, <c>knots</c>,
/// <c>weights</c> and <c>periodic</c>. Horizontal arcs and circles have <c>center</c>, <c>radius</c>, <c>start</c> and <c>sweep</c>. Joined curves have
/// <c>pieces</c>. All can have <c>name</c>, <c>area</c>, <c>width</c>, <c>height</c>, <c>flow</c>, <c>speed</c>, <c>tool</c>, <c>layer</c> and <c>dot</c>.
/// Settings outside <c>curves</c> apply to all. A point is a list of two or three numbers, or an object with x, y, z and its own area, width, height and speed.
/// Percentages are texts like <c>"80%"</c>.
/// </summary>
internal sealed class JsonCurves(CurveSource source)
{
    private static readonly string[] Settings = ["area", "width", "height", "speed", "flow"];

    private static readonly string[] Known =
        ["curves", "units", "points", "closed", "degree", "knots", "weights", "periodic", "center", "radius", "start", "sweep", "pieces", "name", "tool",
            "layer", "dot", .. Settings];

    private double _unit = source.Options.UnitLength;

    public static void Read(CurveSource source)
    {
        var at = ByteOrderMark.Length(source.Bytes);
        using var text = new StreamReader(new MemoryStream(source.Bytes, at, source.Bytes.Length - at, false), new UTF8Encoding(false), false);
        using var reader = new JsonTextReader(text) { FloatParseHandling = FloatParseHandling.Decimal, DateParseHandling = DateParseHandling.None,
            MaxDepth = 64 };
        JToken root;
        try
        {
            root = JToken.Load(reader, new JsonLoadSettings { LineInfoHandling = LineInfoHandling.Load });
            // Anything but comments after the end is an error of the reader.
            while (reader.Read())
            {
            }
        }
        catch (JsonReaderException e)
        {
            source.Fail("curves.json", FirstSentence(e.Message), source.Place(Math.Max(1, e.LineNumber), Math.Max(1, e.LinePosition)));
            return;
        }
        catch (Exception e) when (e is OverflowException or FormatException or ArgumentException or InvalidCastException)
        {
            // The library does not check the range of numbers.
            source.Fail("curves.json", "A number is out of range.", source.Place(Math.Max(1, reader.LineNumber), Math.Max(1, reader.LinePosition)));
            return;
        }
        new JsonCurves(source).Root(root);
    }

    private void Root(JToken root)
    {
        switch (root)
        {
            case JArray { Count: > 0 } list when IsPoint(list[0]):
                Curve(list, []);
                break;
            case JArray list:
                Curves(list, []);
                break;
            case JObject whole when whole["curves"] is JArray list:
                Unknown(whole);
                Units(whole["units"]);
                Curves(list, [whole]);
                break;
            case JObject whole when whole["curves"] is null:
                Units(whole["units"]);
                Curve(whole, []);
                break;
            default:
                Report(new CurveException("curves.json", "Expected a list of points, a list of curves, or an object with \"curves\".", root));
                break;
        }
    }

    private void Units(JToken? token)
    {
        if (token is null) return;
        var name = token.Type == JTokenType.String ? (string)token! : "";
        var length = name switch
        {
            "mm" => 1,
            "cm" => 10,
            "m" => 1000,
            "in" or "inch" => Basics.Units.MmPerInch,
            _ => 0,
        };
        if (length == 0) Report(new CurveException("curves.json", "Units must be \"mm\", \"cm\", \"m\" or \"in\".", token));
        else _unit = length;
    }

    private void Curves(JArray list, JObject[] outer)
    {
        for (var i = 0; i < list.Count; i++)
        {
            if ((i & 0xFF) == 0) source.Pulse(i, list.Count);
            if (!Curve(list[i], outer)) return;
        }
    }

    // False where nothing more is to be read.
    private bool Curve(JToken token, JObject[] outer)
    {
        var goesOn = source.Diagnostics.HasErrors;
        try
        {
            var values = new double[]?[CurveColumns.Settings];
            if (Shape(token, values, 0) is not { } curve) return true;
            goesOn = false;
            var user = new UserCurve(curve) { Source = Place(token) };
            // From the outside in: inner settings win.
            foreach (var holder in token is JObject own ? outer.Concat([own]) : outer) user = Apply(user, holder);
            source.Curves.Add(CurveColumns.WithValues(user, values));
            return true;
        }
        catch (CurveException problem)
        {
            Report(problem);
            return goesOn;
        }
    }

    private UserCurve Apply(UserCurve user, JObject holder)
    {
        Unknown(holder);
        var found = new double?[Settings.Length];
        for (var i = 0; i < Settings.Length; i++)
        {
            if (holder[Settings[i]] is { } token) found[i] = Setting(token, Settings[i]);
        }
        user = CurveColumns.With(user, found);
        if (holder["name"] is { Type: JTokenType.String } name) user = user with { Name = (string)name! };
        if (holder["tool"] is { } tool)
        {
            if (Number(tool) is not (>= 0 and <= 1000 and var number))
                throw new CurveException("curves.json", "The tool must be a number from 0 to 1000.", tool);
            user = user with { Tool = (int)number };
        }
        if (holder["dot"] is { } dot)
        {
            if (Number(dot) is not (>= 0 and var volume)) throw new CurveException("curves.json", "The volume of a dot must be 0 mm³ or more.", dot);
            user = user with { Dot = volume };
        }
        if (holder["layer"] is { } layer)
        {
            if (Number(layer) is not (>= -1e8 and <= 1e8 and var number)) throw new CurveException("curves.json", "The layer must be an integer.", layer);
            user = user with { Layer = new Toolpaths.Layer((int)number, user.Curve.Bounds.Max.Z) };
        }
        return user;
    }

    private Curve? Shape(JToken token, double[]?[]? values, int depth)
    {
        if (token is JArray list) return Polyline(list, false, values, token);
        if (token is not JObject curve) throw new CurveException("curves.json", "A curve must be a list of points or an object.", token);
        try
        {
            if (curve["pieces"] is JArray pieces) return Joined(pieces, depth, token);
            if (curve["center"] is { } center) return ArcOf(curve, center);
            if (curve["points"] is not JArray points) throw new CurveException("curves.json", "A curve needs \"points\", \"center\" or \"pieces\".", token);
            if (curve["degree"] is { } degree) return Nurbs(curve, points, degree);
            return Polyline(points, Flag(curve["closed"]), values, token);
        }
        catch (ArgumentException e)
        {
            throw new CurveException("curves.json", FirstSentence(Messages.Clean(e)), token);
        }
    }

    private Curve? Joined(JArray pieces, int depth, JToken token)
    {
        if (depth > 8) throw new CurveException("curves.json", "Pieces are nested too deeply.", token);
        var curves = new List<Curve>();
        foreach (var piece in pieces)
        {
            if (Shape(piece, null, depth + 1) is not { } curve) return null;
            curves.Add(curve);
        }
        return new PolyCurve(curves);
    }

    private ArcCurve ArcOf(JObject curve, JToken center)
    {
        var origin = Point(center, null);
        var radius = Read(curve["radius"] ?? throw new CurveException("curves.json", "The \"radius\" is missing.", center));
        var start = curve["start"] is { } from ? Read(from) : 0;
        var sweep = curve["sweep"] is { } turn ? Read(turn) : 360;
        var (sin, cos) = Angle.SinCos(start);
        return new ArcCurve(Frame.FromAxes(origin, new Vec3(cos, sin), new Vec3(-sin, cos)), radius * _unit, sweep);
    }

    private NurbsCurve Nurbs(JObject curve, JArray list, JToken degreeToken)
    {
        if (Number(degreeToken) is not (>= 1 and <= 64 and var degree)) throw new CurveException("curves.json", "The degree must be 1 to 64.", degreeToken);
        var points = list.Select(item => Point(item, null)).ToList();
        var weights = curve["weights"] is { } w ? List(w) : null;
        var knots = curve["knots"] is { } k ? List(k) : null;
        if (Flag(curve["periodic"])) return NurbsCurve.Periodic((int)degree, points, weights);
        return knots is null ? NurbsCurve.Clamped((int)degree, points, weights) : new NurbsCurve((int)degree, points, knots, weights);
    }

    private Curve? Polyline(JArray list, bool closed, double[]?[]? values, JToken token)
    {
        var points = new Vec3[list.Count];
        var rows = new double?[list.Count][];
        for (var i = 0; i < points.Length; i++)
        {
            rows[i] = new double?[CurveColumns.Settings];
            points[i] = Point(list[i], rows[i]);
        }
        if (points.Length == 1 && token is JObject { } holder && holder["dot"] is not null) return new PolylineCurve([points[0], points[0]]);
        var curve = source.Polyline(points, closed, Place(token), out var endDropped);
        if (curve is null || values is null) return curve;
        for (var c = 0; c < CurveColumns.Settings; c++)
        {
            var column = c;
            var given = rows.Count(r => r[column] is not null);
            if (given == 0) continue;
            if (given < rows.Length)
            {
                throw new CurveException("curves.json", $"Either all points of a curve must have \"{Settings[c]}\", or none.",
                    list[Array.FindIndex(rows, r => r[column] is null)]);
            }
            values[c] = rows.Take(rows.Length - (endDropped ? 1 : 0)).Select(r => r[column]!.Value).ToArray();
        }
        return curve;
    }

    private static bool IsPoint(JToken token)
        => token is JArray { Count: 2 or 3 } list ? list[0].Type is JTokenType.Integer or JTokenType.Float : token is JObject point && point["x"] is not null;

    private Vec3 Point(JToken token, double?[]? settings)
    {
        double x, y, z = 0;
        if (token is JArray { Count: 2 or 3 } list)
        {
            (x, y) = (Read(list[0]), Read(list[1]));
            if (list.Count == 3) z = Read(list[2]);
        }
        else if (token is JObject point && point["x"] is { } tx && point["y"] is { } ty)
        {
            (x, y) = (Read(tx), Read(ty));
            if (point["z"] is { } tz) z = Read(tz);
            for (var c = 0; c < CurveColumns.Settings && settings is not null; c++)
            {
                if (point[Settings[c]] is { } value) settings[c] = Setting(value, Settings[c]);
            }
        }
        else
        {
            throw new CurveException("curves.json", "A point must be a list of two or three numbers, or an object with x and y.", token);
        }
        var placed = new Vec3(x * _unit, y * _unit, z * _unit);
        return placed.IsFinite ? placed : throw new CurveException("curves.not_finite", "Coordinates must be finite.", token);
    }

    private static double[] List(JToken token)
        => token is JArray list ? list.Select(Read).ToArray() : throw new CurveException("curves.json", "Expected a list of numbers.", token);

    private double Setting(JToken token, string key)
    {
        double value;
        if (token.Type == JTokenType.String && ((string)token!).Trim() is { Length: > 1 } text && text[text.Length - 1] == '%'
            && NumberReader.TryParse(text.Substring(0, text.Length - 1).Trim(), out var percent))
        {
            var reference = CurveColumns.Whole(CurveColumns.Of(key), source.Options);
            if (!(reference > 0)) throw new CurveException("curves.percent", CurveColumns.NoPercentage, token);
            value = percent / 100 * reference;
        }
        else
        {
            value = Read(token);
        }
        return value >= 0 ? value : throw new CurveException("curves.bead", CurveColumns.Negative, token);
    }

    private static bool Flag(JToken? token) => token is { Type: JTokenType.Boolean } flag && (bool)flag;

    private static double Read(JToken token)
        => Number(token) is { } value && !double.IsNaN(value) ? value : throw new CurveException("curves.number", "Expected a finite number.", token);

    // Through text, so that the value is the same on every runtime.
    private static double? Number(JToken token)
        => token is JValue { Value: IFormattable number, Type: JTokenType.Integer or JTokenType.Float }
            && NumberReader.TryParse(number.ToString(null, CultureInfo.InvariantCulture), out var value) ? value : null;

    private void Unknown(JObject holder)
    {
        foreach (var property in holder.Properties())
        {
            if (Array.IndexOf(Known, property.Name) < 0)
                source.Diagnostics.Add(Severity.Warning, "curves.ignored",
                    $"Unknown key \"{(property.Name.Length > 30 ? property.Name.Substring(0, 30) : property.Name)}\" is ignored.",
                    Place(property));
        }
    }

    private SourceLocation Place(JToken token)
        => token is IJsonLineInfo info && info.HasLineInfo() ? source.Place(info.LineNumber, info.LinePosition) : new SourceLocation(source.Name);

    private void Report(CurveException problem) => source.Fail(problem.Code, problem.Message, Place(problem.Token));

    private static string FirstSentence(string message)
    {
        var end = message.IndexOf(". ", StringComparison.Ordinal);
        return end > 0 ? message.Substring(0, end + 1) : message;
    }

    // Ends the curve at hand.
    private sealed class CurveException(string code, string message, JToken token) : Exception(message)
    {
        public string Code { get; } = code;

        public JToken Token { get; } = token;
    }
}
