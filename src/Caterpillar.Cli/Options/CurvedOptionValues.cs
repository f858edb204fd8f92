namespace Caterpillar.Cli;

/// <summary>Options for slicing along surfaces. Surfaces and formulas use the coordinates of the model's file and move with the model.</summary>
internal sealed class CurvedOptionValues
{
    private static readonly string[] MeshEndings = [".stl", ".obj", ".ply", ".3mf", ".gz"];

    private readonly Described<string[]> _surface = new("--surface",
        "Surface that layers follow. FILE: a mesh. FORMULA: its height in x and y, such as 10 + 2 * sin(9 * x). IMAGE: a height map (PNG) over the model, "
            + "with the heights of black and white. Repeatable with --field between, lowest first.", "FILE|FORMULA|IMAGE:LOW,HIGH");

    private readonly Described<string?> _field = new("--field",
        "Shape of the layers. vertical: copies of the surface, moved up. normal: offset copies. between: evenly from the bed to the surface, or between "
            + "several. harmonic, geodesic: evenly from the lower to the upper ends of the model, even if it branches (geodesic: by distances). smooth: level "
            + "layers that bend so that gently sloped tops have no steps. FORMULA: level sets in x, y, z, r and theta, such as z - 2 * sin(9 * x).",
        "vertical|normal|between|harmonic|geodesic|smooth|FORMULA");

    private readonly Described<string?> _blend = new("--blend",
        "Layers are flat up to FROM, follow the surface from TO on, and blend in between, in mm. Default for FROM: the first layer.", "[FROM,]TO");

    /// <summary>The object that is printed on.</summary>
    public OntoOptions Onto { get; } = new(
        "Object to print onto, such as a scanned mesh. The bottom of the model follows its surface. With --surface or --field, the model stays in place and "
            + "only the part above the object is printed.");

    private readonly Described<string?> _deform = new("--deform",
        "Bend the model, slice it flat, and bend the toolpath back. cone=DEG: layers descend outward, or rise if negative. overhangs: layers descend from the "
            + "model's footprint on the bed. X;Y;Z: formulas for the bent point.", "cone=DEG|overhangs[=DEG]|X;Y;Z");

    private readonly BoundaryOptions _boundaries = new();

    public Option[] All => [_surface, _field, _blend, _deform, .. Onto.All, .. _boundaries.All];

    public bool IsGiven(ParseResult arguments) => HasField(arguments) || Onto.IsGiven(arguments);

    /// <summary>True if layers are curved, false if flat layers are put onto an object.</summary>
    public bool HasField(ParseResult arguments)
        => arguments.GetValue(_surface) is { Length: > 0 } || arguments.GetValue(_field) is not null || arguments.GetValue(_deform) is not null;

    /// <summary>False for options that do not follow copies of a model.</summary>
    public bool CanBeCopied(ParseResult arguments) => arguments.GetValue(_deform)?.Contains(';') != true;

    /// <summary>Finds wrong usage before files are read.</summary>
    /// <exception cref="CliException">Options do not go together.</exception>
    public void Check(ParseResult arguments)
    {
        var (surfaces, field) = (arguments.GetValue(_surface) ?? [], arguments.GetValue(_field));
        if (arguments.GetValue(_deform) is not null
            && (surfaces.Length > 0 || field is not null))
        {
            throw CliException.Usage("--deform cannot be combined with --surface or --field.");
        }
        var kind = field ?? "vertical";
        var ends = IsBetweenEnds(kind, surfaces);
        if (_boundaries.IsGiven(arguments) && !ends) throw CliException.Usage("--from and --to need --field harmonic or geodesic.");
        if (ends && surfaces.Length > 0) throw CliException.Usage($"--field {kind} cannot be combined with --surface. Use --from and --to.");
        if (!ends && kind is "vertical" or "normal" && surfaces.Length == 0 && field is not null) throw CliException.Usage($"--field {kind} needs --surface.");
        if (!ends && kind is not ("vertical" or "normal" or "between") && surfaces.Length > 0)
            throw CliException.Usage($"--field {(kind == "smooth" ? kind : "with a formula")} cannot be combined with --surface.");
        if (kind is "vertical" or "normal" && surfaces.Length > 1) throw CliException.Usage("Several surfaces need --field between.");
        if (arguments.GetValue(_blend) is { } blend)
        {
            if (kind != "vertical" || surfaces.Length == 0) throw CliException.Usage("--blend needs --surface and --field vertical.");
            _ = Blend(blend);
        }
        Onto.Check(arguments, !HasField(arguments));
    }

    /// <summary>The field of the layers.</summary>
    /// <param name="arguments">The command line.</param>
    /// <param name="models">The models at their print positions.</param>
    /// <param name="setup">The printer, whose head limits overhangs.</param>
    /// <param name="session">Reads files.</param>
    public LayerField Field(ParseResult arguments, IReadOnlyList<NamedMesh> models, PrintSetup setup, Session session)
    {
        var placed = models[0].Placed;
        if (arguments.GetValue(_deform) is { } deform) return Deformed(deform, models, setup, session);
        var surfaces = arguments.GetValue(_surface) ?? [];
        var kind = arguments.GetValue(_field) ?? "vertical";
        if (IsBetweenEnds(kind, surfaces))
        {
            var part = TriMesh.Merge(models.Select(m => m.Mesh));
            var ends = _boundaries.Of(arguments, part, placed, session);
            return kind == "geodesic" ? LayerField.Geodesic(ends, session.Cancel) : LayerField.Harmonic(ends, session.Cancel);
        }
        switch (kind)
        {
            case "vertical":
                return LayerField.Vertical(Surface(surfaces[0], models, session), arguments.GetValue(_blend) is { } blend ? Blend(blend) : null);
            case "normal":
                return LayerField.Offset(Meshes.ReadAsOne(surfaces[0], session).Transformed(placed));
            case "between":
                var plans = surfaces.Select(s => Surface(s, models, session)).ToList();
                // One surface: from the bottom of the models up to it.
                if (plans.Count == 1) plans.Insert(0, PlanSurface.Level(models.Min(m => m.Mesh.Bounds.Min.Z)));
                return LayerField.Between(plans.ToArray());
            case "smooth":
                return session.ValueOrFail(LayerField.Smooth(models, setup, session.Cancel));
            case var formula:
                return session.ValueOrFail(LayerField.Formula(formula, placed, new SourceLocation(Key: "--field")), ExitCode.Usage);
        }
    }

    // Between surfaces, or between ends of the model itself.
    private static bool IsBetweenEnds(string kind, string[] surfaces) => kind is "harmonic" or "geodesic" || (kind == "between" && surfaces.Length == 0);

    private static LayerField Deformed(string text, IReadOnlyList<NamedMesh> models, PrintSetup setup, Session session)
    {
        var (word, number) = text.Split('=', 2) is [var w, var n] ? (w.Trim(), n) : (text.Trim(), null);
        if (word == "cone" && number is not null)
        {
            var bounds = Bounds.Of(models.SelectMany(m => new[] { m.Mesh.Bounds.Min, m.Mesh.Bounds.Max }));
            return LayerField.Vertical(PlanSurface.Cone(bounds.Center, Degrees(number)));
        }
        if (word == "overhangs")
        {
            double? degrees = number is null ? null : Degrees(number);
            return LayerField.Vertical(session.ValueOrFail(PlanSurface.AgainstOverhangs(models, setup, degrees)));
        }
        if (text.Split(';') is [var x, var y, var z])
            return session.ValueOrFail(LayerField.Deformed(x, y, z, models[0].Placed, new SourceLocation(Key: "--deform")), ExitCode.Usage);
        throw CliException.Usage("--deform needs cone=DEGREES, overhangs, overhangs=DEGREES, or three formulas \"X; Y; Z\".");
    }

    private static double Degrees(string text)
        => Numbers.List(text, "--deform") is [var degrees and >= -80 and <= 80] ? degrees
            : throw CliException.Usage("--deform needs an angle of −80 to 80 degrees.");

    private static PlanSurface Surface(string text, IReadOnlyList<NamedMesh> models, Session session)
    {
        var placed = models[0].Placed;
        if (text.LastIndexOf(':') is > 1 and var colon && IsImage(text[..colon]))
        {
            if (Numbers.List(text[(colon + 1)..], "--surface") is not [var low, var high]
                || !(high >= low))
            {
                throw CliException.Usage("--surface: a height map needs IMAGE:LOW,HIGH with two heights in mm.");
            }
            var image = session.ValueOrFail(ImageReader.Read(session.ReadBytes(text[..colon]), text[..colon]));
            // Over the models as they are in their files.
            var bounds = ModelPlacement.BoxOf(models.Select(m => m.Transformed(placed.Inverse)).ToArray());
            return Transformed(PlanSurface.HeightMap(image, new Bounds(bounds.Min.WithZ(low), bounds.Max.WithZ(high))), placed);
        }
        if (IsImage(text)) throw CliException.Usage("--surface: a height map needs the heights of black and white in mm: IMAGE:LOW,HIGH.");
        if (MeshEndings.Any(e => text.EndsWith(e, StringComparison.OrdinalIgnoreCase)) || File.Exists(text))
            return PlanSurface.Of(Meshes.ReadAsOne(text, session).Transformed(placed));
        return Transformed(session.ValueOrFail(PlanSurface.Formula(text, new SourceLocation(Key: "--surface")), ExitCode.Usage), placed);
    }

    private static PlanSurface Transformed(PlanSurface surface, Affine placed)
        => placed.IsUpright ? surface.Transformed(placed) : throw CliException.Usage("--rotate: only a mesh as --surface can be rotated about X and Y.");

    private static bool IsImage(string file) => file.EndsWith(".png", StringComparison.OrdinalIgnoreCase);

    private static LayerBlend Blend(string text) => Numbers.List(text, "--blend") switch
    {
        [var to and > 0] => new LayerBlend(0, to),
        [var from and >= 0, var to] when to > from => new LayerBlend(from, to),
        _ => throw CliException.Usage("--blend needs TO or FROM,TO: heights in mm, FROM below TO."),
    };
}
