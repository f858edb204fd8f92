namespace Caterpillar.Turtles;

/// <summary>Applies a shaping block to the steps drawn in it, in the coordinates of the turtle at the start of the block.</summary>
internal sealed class Shaper(ShapingRules rules, FormulaContext context, Frame frame, Turtle turtle)
{
    // Deviation of deformed paths, mm, as in the component.
    private const double Tolerance = 0.01;

    private int Slot => rules.Local ? context.Base + rules.Slot : rules.Slot;

    /// <summary>The steps with shaped paths, or null and an error.</summary>
    public Result<IReadOnlyList<Step>> Apply(IReadOnlyList<Step> steps, CancellationToken cancel)
    {
        var isLocal = rules.Kind is ShapingKind.Deform or ShapingKind.Modulate;
        var toLocal = isLocal ? Affine.ToFrame(frame) : Affine.Identity;
        var toWorld = isLocal ? Affine.FromFrame(frame) : Affine.Identity;
        var paths = steps.OfType<PathStep>().Select(s => isLocal ? s.Path.Transformed(toLocal) : s.Path).ToList();
        var deformation = rules.Kind == ShapingKind.Deform ? Deformation() : null;
        var shaped = rules.Kind switch
        {
            ShapingKind.Deform => deformation!.Apply(paths, Number("tolerance", Tolerance, 0, 100), null, cancel),
            ShapingKind.Modulate => Modulation().Apply(paths, null, cancel),
            ShapingKind.GapBead => GapBead().Apply(paths, null, cancel),
            _ => Cooling().Apply(paths, cancel),
        };
        if (shaped.Value is null) return new Result<IReadOnlyList<Step>>(null, shaped.Diagnostics);
        var result = new Step[steps.Count];
        var next = 0;
        for (var i = 0; i < result.Length; i++)
        {
            result[i] = steps[i] switch
            {
                PathStep path => path with { Path = isLocal ? shaped.Value[next++].Transformed(toWorld) : shaped.Value[next++] },
                TravelStep travel when deformation is not null => Moved(travel, deformation),
                _ => steps[i],
            };
        }
        return new Result<IReadOnlyList<Step>>(result, shaped.Diagnostics);
    }

    private TravelStep Moved(TravelStep travel, Deformation deformation)
    {
        var points = new Vec3[travel.Points.Count];
        for (var i = 0; i < points.Length; i++) points[i] = frame.ToLocal(travel.Points[i]);
        points = deformation.Map(points);
        for (var i = 0; i < points.Length; i++)
        {
            points[i] = frame.ToWorld(points[i]);
            if (!points[i].IsFinite) throw Error("shape.position", "The position formulas give a point that is not finite.");
        }
        return new TravelStep(points, travel.Speed, travel.Intent);
    }

    private Deformation Deformation()
    {
        var (first, second) = rules.IsCylindrical ? (rules["r"], rules["theta"]) : (rules["x"], rules["y"]);
        var (third, area, speed) = (rules["z"], rules["c"], rules["v"]);
        PositionMap? position = first is null && second is null && third is null ? null : p =>
        {
            Place(p);
            return new Vec3(first?.Evaluate(context) ?? p.X, second?.Evaluate(context) ?? p.Y, third?.Evaluate(context) ?? p.Z);
        };
        ValueMap? areas = area is null ? null : (value, p) => OfValue(area, 5, value, p);
        ValueMap? speeds = speed is null ? null : (value, p) => OfValue(speed, 6, value, p);
        return rules.IsCylindrical ? Shaping.Deformation.Cylindrical(position, areas, speeds) : Shaping.Deformation.Cartesian(position, areas, speeds);
    }

    private double OfValue(Argument formula, int slot, double value, Vec3 place)
    {
        Place(place);
        context.Values[Slot + slot] = value;
        return formula.Evaluate(context);
    }

    // x, y, z, r, theta from a position in the system of the block.
    private void Place(Vec3 p)
    {
        var (values, slot) = (context.Values, Slot);
        var (at, other) = rules.IsCylindrical ? (3, 0) : (0, 3);
        values[slot + at] = p.X;
        values[slot + at + 1] = p.Y;
        values[slot + 2] = p.Z;
        if (!rules.NeedsBoth) return;
        var (sin, cos) = rules.IsCylindrical ? Angle.SinCos(p.Y) : default;
        values[slot + other] = rules.IsCylindrical ? p.X * cos : p.LengthXY;
        values[slot + other + 1] = rules.IsCylindrical ? p.X * sin : Angle.Atan2(p.Y, p.X);
    }

    private Modulation Modulation()
    {
        var moves = rules.Mode is ModulationMode.DisplaceLeft or ModulationMode.DisplaceUp;
        return new Modulation(rules.Mode, Field(rules["field"]!), Number("low", moves ? 0 : 1, -1000, 1000), Number("high", 0.65, -1000, 1000))
        {
            Mask = rules["mask"] is { } mask ? Field(mask) : null,
            Resolution = Number("resolution", 0, 0, 1e6),
        };
    }

    private Field Field(Argument formula) => place =>
    {
        var (values, slot) = (context.Values, Slot);
        var p = place.Position;
        values[slot] = p.X;
        values[slot + 1] = p.Y;
        values[slot + 2] = p.Z;
        values[slot + 7] = place.Distance;
        values[slot + 8] = place.Length > 0 ? place.Distance / place.Length : 0;
        values[slot + 9] = place.Path;
        if (rules.NeedsBoth)
        {
            values[slot + 3] = p.LengthXY;
            values[slot + 4] = Angle.Atan2(p.Y, p.X);
        }
        return formula.Evaluate(context);
    };

    private GapBead GapBead()
    {
        var height = turtle.Bead.Height > 0 ? turtle.Bead.Height : 0.2;
        var plain = new GapBead
        {
            MinGap = Number("min_gap", height / 4, 1e-3, 100),
            MaxGap = Number("max_gap", height * 2, 1e-3, 100),
            Width = Number("width", 0, 0, 100),
            Bed = Number("bed", 1, 0, 1) != 0 ? 0 : null,
            Shape = turtle.Shape,
        };
        if (plain.MinGap > plain.MaxGap) throw Error("turtle.value", "min_gap is above max_gap.");
        return plain with { AirGap = Math.Max(height * 4, 2 * plain.MaxGap) };
    }

    private Cooling Cooling() => new()
    {
        MinLayerTime = Number("min_layer_time", 5, 0, 1e6),
        SpeedByLength = Number("speed_by_length", 0, 0, 1) != 0,
        MinPrintSpeed = Number("min_speed", 5, 1e-3, 1e6),
        MaxSegmentsPerSecond = Number("max_segment_rate", 100, 0, 1e6),
        ReferenceSpeed = turtle.Speed,
    };

    private double Number(string name, double usual, double low, double high)
    {
        if (rules[name] is not { } formula) return usual;
        var value = formula.Evaluate(context);
        return value >= low && value <= high ? value : throw new FormulaException("turtle.value",
            $"'{name}' must be a number from {NumberFormatter.Format(low, 3)} to {NumberFormatter.Format(high, 3)}.", formula.At);
    }

    private FormulaException Error(string code, string message) => new(code, message, rules.At);
}
