namespace Caterpillar.GH.Goos;

/// <summary>A print path on a wire. Native components move, rotate and scale it like a curve, and can use it as one.</summary>
public sealed class PrintPathGoo : DrawnGoo<PrintPath>
{
    private PathStep? _step;

    // The curve that a user connected instead of a print path.
    private UserCurve? _drawn;

    public PrintPathGoo()
    {
    }

    /// <summary>A path, and the setup that it was made with.</summary>
    public PrintPathGoo(PrintPath? path, PrintSetup? setup = null)
    {
        Value = path!;
        Setup = setup;
    }

    /// <summary>A path from a slicer or a turtle, with its data for planning: group, fixed start, layer and source.</summary>
    public PrintPathGoo(PathStep? step, PrintSetup? setup = null)
        : this(step?.Path, setup)
    {
        _step = step;
    }

    /// <summary>The setup that it was made with. Null if nothing of it depends on one.</summary>
    public PrintSetup? Setup { get; private set; }

    public override string TypeName => "Print Path";

    public override string TypeDescription => "A path to print, with its beads in mm² and speeds in mm/s.";

    public override IGH_GeometricGoo DuplicateGeometry() => Value is null ? new PrintPathGoo() : new PrintPathGoo(ToStep(), Setup) { _drawn = _drawn };

    /// <summary>The path as a step of a design.</summary>
    public PathStep ToStep() => ReferenceEquals(_step?.Path, Value) ? _step! : _step = new PathStep(Value);

    /// <summary>The path as a step of a print. A curve that was connected as it is gets the bead and the division of the settings.</summary>
    public PathStep StepFor(PrintSetup setup) => _drawn is not null && Drawn(_drawn, setup.Settings) is { } path ? new PathStep(path) : ToStep();

    /// <summary>The same with another path, without the region of its layer.</summary>
    public PrintPathGoo With(PrintPath path) => ReferenceEquals(path, Value) ? this : new PrintPathGoo(ToStep() with { Path = path, Region = null }, Setup);

    public override bool CastFrom(object source)
    {
        if (Wrapped.Bare(source) is not PrintPathGoo { Value: not null } other) return base.CastFrom(source);
        (Value, _step, _drawn, Setup) = (other.Value, other._step, other._drawn, other.Setup);
        return true;
    }

    public override bool Write(GH_IWriter writer)
    {
        if (Value is null) return true;
        writer.SetByteArray("Step", StepBytes.Pack(ToStep()));
        if (Setup is not null) new SetupGoo { Value = Setup }.Write(writer.CreateChunk("Setup"));
        return true;
    }

    public override bool Read(GH_IReader reader)
    {
        if (!reader.ItemExists("Step")) return true;
        var setup = new SetupGoo();
        if (StepBytes.Unpack(reader.GetByteArray("Step")) is not PathStep step || !setup.ReadPart(reader)) return false;
        (Value, _step, Setup) = (step.Path, step, setup.Value);
        return true;
    }

    public override IGH_GeometricGoo? Morph(Rg.SpaceMorph xmorph)
    {
        if (Value is null) return null;
        var units = DocumentUnits.Current;
        // The image of an arc is no arc.
        var straight = PathArcs.Expand(Value);
        var points = straight.Points.Select(p => RhinoGeometry.ToVec(xmorph.MorphPoint(RhinoGeometry.ToPoint(p, units)), units)).ToList();
        var beads = Enumerable.Range(0, straight.SegmentCount).Select(straight.BeadOf).ToList();
        return With(straight.WithGeometry(points, beads, straight.IsClosed));
    }

    public override string ToString()
    {
        if (Value is null) return "No Print Path";
        var role = Value.Role == Role.Unspecified ? "" : Value.Role + ", ";
        return $"Print Path ({role}{NumberFormatter.Format(Value.Points.Count)} points, {NumberFormatter.Format(Value.Length, 2)} mm, "
            + $"{NumberFormatter.Format(Value.Volume, 2)} mm³{(Value.IsClosed ? ", closed" : "")})";
    }

    private protected override Bounds Bounds => Value.Bounds;

    private protected override int SegmentCount => Value.SegmentCount;

    private protected override int LayerCount => (Value.Layer?.Index ?? -1) + 1;

    /// <summary>A curve, line, polyline, arc or circle is printed with the bead and the division of the standard settings, until a setup is known.</summary>
    private protected override bool CastFromOther(object? source)
    {
        if (RhinoCurves.In(source) is not { } curve) return false;
        try
        {
            _drawn = new UserCurve(RhinoCurves.ToCurve(curve, DocumentUnits.Current));
            Value = Drawn(_drawn, new PrintSettings())!;
            return Value is not null;
        }
        catch (InputProblem)
        {
            return false;
        }
    }

    private static PrintPath? Drawn(UserCurve curve, PrintSettings settings)
        => CurvePaths.ToPaths([curve], CurveOptions.From(settings)).Value?.FirstOrDefault();

    private protected override object? Native(Type wanted, DocumentUnits units) => NativeCasts.Of(Value, wanted, units);

    private protected override IEnumerable<BakedPart> ToParts(DocumentUnits units) => BakedPart.Of(Value, units) is { } part ? [part] : [];

    private protected override void AddWires(List<Rg.Line> lines, DocumentUnits units, Thinning thinning, int first)
    {
        for (var i = 0; i < Value.SegmentCount; i++)
        {
            if (thinning.Has(Value.Layer?.Index ?? 0, first + i)) RhinoGeometry.AddLines(lines, Value.Points[i], Value.EndOf(i), Value.ArcOf(i), units);
        }
    }

    private protected override IGH_GeometricGoo Image(Affine map) => With(Value.Transformed(map));
}
