using System.Xml;

namespace Caterpillar.Drawings;

/// <summary>
/// Paths and basic shapes of SVG, in the order of the file, as curves in mm. Group transforms, units and viewBox are applied. The lower left corner of the page
/// is at the origin. Settings are attributes of shapes or groups: <c>data-width</c>, <c>data-height</c>, <c>data-area</c>, <c>data-speed</c>,
/// <c>data-flow</c>, <c>data-z</c>, <c>data-tool</c> and <c>data-layer</c> (mm, mm², mm/s). Width, height, speed and flow can be percentages. References
/// (<c>use</c>, <c>symbol</c>) are followed. Text is drawn in a single-line font (<see cref="StrokeFont"/>). Hidden elements and definitions are ignored.
/// </summary>
internal sealed class SvgReader(CurveSource source, SvgXml xml)
{
    private const int MaxDepth = 512;

    private static readonly HashSet<string> Definitions =
        ["defs", "symbol", "clipPath", "mask", "pattern", "marker", "metadata", "style", "title", "desc", "script", "linearGradient", "radialGradient",
            "filter", "font"];

    private static readonly HashSet<string> Shapes = ["path", "line", "polyline", "polygon", "rect", "circle", "ellipse"];

    // Capitals of common fonts, in sizes of the font.
    private const double CapHeight = 0.7;
    private const double UsualSize = 16;

    private const int MaxUses = 100_000;
    private const int MaxUseDepth = 32;
    private const double BytesPerCurve = 400;

    private double _pageHeight = double.NaN;
    private (double Width, double Height)? _viewport;
    private int _uses;
    private int _useDepth;

    private XmlReader Xml => xml.Reader;

    public static void Read(CurveSource source)
    {
        using var reader = new StreamReader(new MemoryStream(source.Bytes));
        var text = reader.ReadToEnd();
        using var xml = SvgXml.Open(text);
        try
        {
            new SvgReader(source, new SvgXml(source, text, xml)).ReadAll();
        }
        catch (XmlException e)
        {
            var message = e.Message;
            var end = message.IndexOf(" Line ", StringComparison.Ordinal);
            source.Fail("curves.svg", end > 0 ? message.Substring(0, end) : message, source.Place(Math.Max(1, e.LineNumber), Math.Max(1, e.LinePosition)));
        }
        catch (Exception e) when (e is ArgumentException or InvalidOperationException or IndexOutOfRangeException)
        {
            // Damaged text that makes the XML reader throw.
            source.Fail("curves.svg", "This is not well-formed XML.", source.Place(1));
        }
    }

    private void ReadAll()
    {
        var page = new Scope(Affine.Identity, SvgSettings.None, 0, 0);
        while (Xml.Read())
        {
            if (Xml.NodeType != XmlNodeType.Element) continue;
            if (Xml.LocalName != "svg") source.Fail("curves.svg", "An SVG file must begin with an svg element.", xml.Here());
            else if (!Hides()) ReadContent(page, true);
            return;
        }
    }

    // What an element "use" refers to; false after an error.
    private bool ReadInside(Scope outer)
    {
        while (Xml.Read())
        {
            if (Xml.NodeType == XmlNodeType.Element) return Hides() || ReadContent(outer, false);
        }
        return true;
    }

    // The element where the reader is, with all that it holds; false after an error.
    private bool ReadContent(Scope first, bool isRoot)
    {
        var scopes = new Stack<Scope>();
        if (!Element(first, isRoot, scopes)) return false;
        while (scopes.Count > 0 && Xml.Read())
        {
            if (Xml.NodeType == XmlNodeType.EndElement) scopes.Pop();
            if (Xml.NodeType != XmlNodeType.Element) continue;
            xml.Pulse();
            if (scopes.Count > MaxDepth)
                return source.Fail("curves.svg", "Elements are nested too deeply.", xml.Here());
            if (!Hides() && !Element(scopes.Peek(), false, scopes)) return false;
        }
        return true;
    }

    private bool Hides()
    {
        if (!xml.IsHidden()) return false;
        source.Diagnostics.Add(Severity.Note, "curves.hidden", "Hidden elements are ignored.", xml.Here());
        xml.SkipContent();
        return true;
    }

    // False after an error.
    private bool Element(Scope outer, bool isRoot, Stack<Scope> scopes)
    {
        var name = Xml.LocalName;
        var isSymbol = name == "symbol" && _viewport is not null;
        if (name == "use") return Use(outer);
        if (name == "text") return Text(outer);
        if (Definitions.Contains(name) && !isSymbol)
        {
            xml.SkipContent();
            return true;
        }
        if (name is not ("svg" or "symbol" or "g" or "a" or "switch") && !Shapes.Contains(name))
        {
            if (name is "image")
            {
                source.Diagnostics.Add(Severity.Warning, "curves.svg_" + name, $"\"{name}\" elements are ignored. Convert them to paths.", xml.Here());
            }
            else if (Xml.NamespaceURI is "" or "http://www.w3.org/2000/svg")
            {
                source.Diagnostics.Add(Severity.Note, "curves.ignored",
                    $"Elements without curves are ignored. The first is \"{(name.Length > 30 ? name.Substring(0, 30) : name)}\".", xml.Here());
            }
            xml.SkipContent();
            return true;
        }
        var empty = Xml.IsEmptyElement;
        if (Enter(outer, name is "svg" or "symbol", isRoot) is not { } scope) return false;
        if (Shapes.Contains(name) && !Shape(name, scope)) return false;
        _viewport = null;
        if (!empty) scopes.Push(scope);
        return true;
    }

    private Scope? Enter(Scope outer, bool isSvg, bool isRoot)
    {
        var map = outer.Map;
        var (width, height) = (outer.Width, outer.Height);
        if (xml.Attribute("transform") is { } transform && !isRoot)
        {
            if (SvgValues.Transform(transform) is not { } own) return xml.Fail<Scope>("transform", "Expected a list of transforms.");
            map = own.Then(map);
        }
        if (isSvg)
        {
            if (View(isRoot, ref width, ref height) is not { } view) return null;
            map = view.Then(isRoot ? ToMm() : map);
        }
        return outer.Settings.Inside(xml, source.Options) is { } settings ? new Scope(map, settings, width, height) : null;
    }

    private Affine? View(bool isRoot, ref double width, ref double height)
    {
        double[]? box = null;
        if (xml.Attribute("viewBox") is { } text)
        {
            box = SvgValues.Numbers(text);
            if (box is not { Length: 4 } || !(box[2] > 0 && box[3] > 0))
                return xml.Fail<Affine?>("viewBox", "A viewBox needs four numbers, the last two positive.");
        }
        var across = _viewport?.Width ?? Extent("width", box is null ? (isRoot ? 0 : width) : box[2], width, isRoot);
        var up = _viewport?.Height ?? Extent("height", box is null ? (isRoot ? 0 : height) : box[3], height, isRoot);
        if (across is not { } ownWidth) return xml.Fail<Affine?>("width", "Expected a length.");
        if (up is not { } ownHeight) return xml.Fail<Affine?>("height", "Expected a length.");
        double x = 0, y = 0;
        if (!isRoot)
        {
            x = SvgValues.Length(xml.Attribute("x"), width) ?? 0;
            y = SvgValues.Length(xml.Attribute("y"), height) ?? 0;
        }
        else
        {
            _pageHeight = ownHeight;
        }
        (width, height) = box is null ? (ownWidth, ownHeight) : (box[2], box[3]);
        return box is null ? Affine.Move(new Vec3(x, y)) : SvgValues.ViewBox(box, x, y, ownWidth, ownHeight, xml.Attribute("preserveAspectRatio"));
    }

    // For the root, a percentage of the unknown window means the size of its viewBox.
    private double? Extent(string name, double missing, double whole, bool isRoot)
    {
        var text = xml.Attribute(name);
        if (text is null || text.Trim() == "auto" || (isRoot && text.Trim().EndsWith("%", StringComparison.Ordinal))) return missing;
        return SvgValues.Length(text, whole) is > 0 and var value ? value : null;
    }

    // Pixels with Y down to mm with Y up, the page above the X axis.
    private Affine ToMm()
    {
        const double S = 1 / SvgValues.PixelsPerMm;
        if (_pageHeight == 0)
            source.Diagnostics.Add(Severity.Note, "curves.svg_page", "The file has no page height. Curves stay below the X axis, as drawn.", xml.Here());
        return new Affine(new Vec3(S, 0), new Vec3(0, -S), Vec3.UnitZ, new Vec3(0, _pageHeight * S));
    }

    private bool Shape(string name, Scope scope)
    {
        var place = xml.Here();
        var diagonal = Math.Sqrt((scope.Width * scope.Width + scope.Height * scope.Height) / 2);
        double? Length(string attribute)
        {
            var text = xml.Attribute(attribute);
            var whole = attribute is "r" ? diagonal : attribute[0] is 'y' || attribute is "cy" or "ry" or "height" ? scope.Height : scope.Width;
            return text is null || text.Trim() == "auto" ? 0 : SvgValues.Length(text, whole);
        }
        var empty = 0;
        IReadOnlyList<Curve>? curves;
        if (name == "path")
        {
            (curves, empty, var error, var at) = SvgPath.Parse(xml.Attribute("d") ?? "");
            if (error is not null)
                return source.Fail("curves.svg_path", error, xml.InAttribute("d", at));
        }
        else
        {
            curves = name switch
            {
                "line" => SvgShapes.Line(Length),
                "polyline" or "polygon" => SvgShapes.Polyline(xml.Attribute("points") ?? "", name == "polygon"),
                "circle" => SvgShapes.Ellipse(Length("cx"), Length("cy"), Length("r"), Length("r")),
                "ellipse" => SvgShapes.Ellipse(Length("cx"), Length("cy"), Length("rx"), Length("ry")),
                _ => SvgShapes.Rectangle(Length, xml.Attribute("rx") is { } rx && rx != "auto", xml.Attribute("ry") is { } ry && ry != "auto"),
            };
        }
        if (curves is null)
            return source.Fail("curves.svg", $"This \"{name}\" element has an invalid attribute.", place);
        if (curves.Count == 0 || empty > 0) source.TooShort(place);
        foreach (var curve in curves) Add(curve, scope, place);
        return true;
    }

    private void Add(Curve curve, Scope scope, SourceLocation place)
    {
        Curve placed;
        try
        {
            placed = curve.Transformed(scope.Map.Then(Affine.Move(new Vec3(0, 0, scope.Settings.Z))));
        }
        catch (ArgumentException)
        {
            // A map that flattens the curve to a point, or beyond the range of numbers.
            source.TooShort(place);
            return;
        }
        if (!placed.Bounds.Min.IsFinite || !placed.Bounds.Max.IsFinite)
        {
            source.Fail("curves.not_finite", "Coordinates must be finite.", place);
            return;
        }
        source.Curves.Add(scope.Settings.Of(placed, place));
    }

    // False after an error.
    private bool Use(Scope outer)
    {
        if (Enter(outer, false, false) is not { } scope) return false;
        var place = xml.Here();
        var href = (xml.Attribute("href") ?? Xml.GetAttribute("href", "http://www.w3.org/1999/xlink") ?? "").Trim();
        double Length(string name, double whole, double missing) => SvgValues.Length(xml.Attribute(name), whole) ?? missing;
        var move = Affine.Move(new Vec3(Length("x", scope.Width, 0), Length("y", scope.Height, 0)));
        var viewport = (Length("width", scope.Width, scope.Width), Length("height", scope.Height, scope.Height));
        xml.SkipContent();
        if (href.Length < 2 || href[0] != '#' || !xml.Named().TryGetValue(href.Substring(1), out var target))
        {
            source.Diagnostics.Add(Severity.Warning, "curves.svg_use", "The target of this \"use\" element is not in the file. It is ignored.", place);
            return true;
        }
        if (++_uses > MaxUses || _useDepth == MaxUseDepth)
            return source.Fail("curves.svg", "\"use\" elements refer to each other, or the file has too many of them.", place);
        if (source.Options.Memory.Refuse(source.Curves.Count * BytesPerCurve, "The curves that \"use\" elements repeat", place) is { } tooMuch)
        {
            source.Diagnostics.Add(tooMuch);
            return false;
        }
        var kept = xml.Reader;
        _useDepth++;
        xml.Reader = target.CreateReader();
        _viewport = viewport;
        var good = ReadInside(scope with { Map = move.Then(scope.Map) });
        _viewport = null;
        xml.Reader = kept;
        _useDepth--;
        return good;
    }

    // False after an error.
    private bool Text(Scope outer)
    {
        if (Enter(outer, false, false) is not { } scope) return false;
        var place = xml.Here();
        var cap = FontSize() * CapHeight;
        var anchor = xml.Property("text-anchor") ?? "start";
        var (x, y) = (0.0, 0.0);
        Place(scope, ref x, ref y);
        if (Xml.IsEmptyElement) return true;
        var depth = Xml.Depth;
        while (Xml.Read() && !(Xml.NodeType == XmlNodeType.EndElement && Xml.Depth == depth))
        {
            if (Xml.NodeType == XmlNodeType.Element) Place(scope, ref x, ref y);
            if (Xml.NodeType is not (XmlNodeType.Text or XmlNodeType.CDATA) || !(cap > 0)) continue;
            var line = OneLine(Xml.Value);
            if (line.Any(c => !StrokeFont.Has(c)))
                source.Diagnostics.Add(Severity.Warning, "curves.svg_letters", "Characters missing from the single-line font are drawn as boxes.", place);
            var width = StrokeFont.Advance(line, cap);
            var start = anchor == "middle" ? x - width / 2 : anchor == "end" ? x - width : x;
            foreach (var stroke in StrokeFont.Strokes(line, cap))
                Add(new PolylineCurve(Array.ConvertAll(stroke, p => new Vec3(start + p.X, y - p.Y)), false), scope, place);
            x += width;
        }
        return true;
    }

    // Where an element of text begins; what it does not say goes on from before.
    private void Place(Scope scope, ref double x, ref double y)
    {
        double? First(string name, double whole) => xml.Attribute(name) is { } list
            ? SvgValues.Length(list.Trim().Split(' ', ',')[0], whole) : null;
        x = (First("x", scope.Width) ?? x) + (First("dx", scope.Width) ?? 0);
        y = (First("y", scope.Height) ?? y) + (First("dy", scope.Height) ?? 0);
    }

    private double FontSize()
    {
        var text = xml.Property("font-size");
        return SvgValues.Length(text, UsualSize) is { } size && size <= 1e6 ? size : UsualSize;
    }

    // Runs of spaces and line ends are one space, as in browsers; letters of two are written as two.
    private static string OneLine(string text)
    {
        var line = new StringBuilder(text.Length);
        foreach (var c in text)
        {
            if (c is ' ' or '\t' or '\n' or '\r')
            {
                if (line.Length > 0 && line[line.Length - 1] != ' ') line.Append(' ');
            }
            else
            {
                line.Append(c switch { '\u00E6' => "ae", '\u00C6' => "AE", '\u0153' => "oe", '\u0152' => "OE", _ => c.ToString(CultureInfo.InvariantCulture) });
            }
        }
        return line.ToString().TrimEnd(' ');
    }

    private sealed record Scope(Affine Map, SvgSettings Settings, double Width, double Height);
}
