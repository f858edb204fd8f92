using Caterpillar.Files;
using Caterpillar.Curved;
using Caterpillar.Slicing;

namespace Caterpillar.Cli;

/// <summary>Options of slicing along surfaces. Surfaces and formulas are in the coordinates of the model's file and move with the model.</summary>
internal sealed class CurvedOptionValues
{
    private static readonly string[] MeshEndings = [".stl", ".obj", ".ply", ".3mf", ".gz"];

    private readonly Described<string[]> _surface = new("--surface",
        "Slice along a surface: a mesh file, a formula for its height in x and y (10 + 2 * sin(9 * x)), or an image (PNG, PGM) as a height map over the model "
            + "with its heights: FILE:LOW,HIGH. Repeated with --field between, from below.", "PLAN");

    private readonly Described<string?> _field = new("--field",
        "Layers are copies of the surface, moved up (vertical) or offset (normal); divide the space from the bed to the surface, or between several (between); "
            + "change evenly along the model from its lower to its upper ends, also where it branches (harmonic, or geodesic by distances); or are level sets "
            + "of a formula in x, y, z, r, theta, such as z - 2 * sin(9 * x).", "vertical|normal|between|harmonic|geodesic|FORMULA");

    private readonly Described<string?> _blend = new("--blend",
        "Layers are level up to FROM mm (the first layer), and follow the surface from TO mm on; between, they change from one to the other.", "[FROM,]TO");

    private readonly OntoOptions _onto = new(
        "Print onto an object, a scanned mesh for example: the bottom of the model is put onto its surface; with --surface or --field the model stays where it "
            + "is, and nothing is printed below the object's surface.",
        "Print what lies within the surface and is not too steep, instead of refusing the model.");

    private readonly Described<string?> _deform = new("--deform",
        "Bend the model, slice it flat, and bend the paths back: cone=DEGREES (layers descend outward, or rise where negative), overhangs or overhangs=DEGREES "
            + "(layers descend from where the model stands on the bed), or formulas for the bent \"x; y; z\".", "cone=DEG|overhangs[=DEG]|X;Y;Z");

    private readonly Described<string?> _tilt = new("--tilt",
        "Tilt the tool along the normals of the layers, on machines with tool center point control: words B and C, or A and C, by at most so many degrees.",
        "bc|ac[=DEG]");

    private readonly BoundaryOptions _boundaries = new();
    private readonly InfillAlong _along = new();

    public Option[] All => [_surface, _field, _blend, _deform, _tilt, .. _onto.All, .. _boundaries.All, .. _along.All];

    public bool IsGiven(ParseResult arguments) => HasField(arguments) || _onto.IsGiven(arguments);

    public bool IsPartial(ParseResult arguments) => _onto.IsPartial(arguments);

    /// <summary>True where layers are curved, false where level layers are put onto an object.</summary>
    public bool HasField(ParseResult arguments)
        => arguments.GetValue(_surface) is { Length: > 0 } || arguments.GetValue(_field) is not null || arguments.GetValue(_deform) is not null;

    /// <summary>Wrong usage is found before files are read.</summary>
    /// <exception cref="CliException">Options do not go together.</exception>
    public void Check(ParseResult arguments)
    {
        var (surfaces, field) = (arguments.GetValue(_surface) ?? [], arguments.GetValue(_field));
        if (arguments.GetValue(_deform) is not null
            && (surfaces.Length > 0 || field is not null))
        {
            throw Usage("--deform and --surface or --field exclude each other.");
        }
        var kind = field ?? "vertical";
        var ends = IsBetweenEnds(kind, surfaces);
        if (_boundaries.IsGiven(arguments) && !ends) throw Usage("--from and --to go with --field harmonic or geodesic.");
        if (ends && surfaces.Length > 0) throw Usage($"--field {kind} goes without --surface: give --from and --to.");
        if (Tilt(arguments) is not null && !HasField(arguments)) throw Usage("--tilt goes with --surface, --field or --deform.");
        if (!ends && kind is "vertical" or "normal" && surfaces.Length == 0 && field is not null) throw Usage($"--field {kind} needs --surface.");
        if (!ends && kind is not ("vertical" or "normal" or "between") && surfaces.Length > 0) throw Usage("A formula for --field goes without --surface.");
        if (kind is "vertical" or "normal" && surfaces.Length > 1) throw Usage("Several surfaces go with --field between.");
        if (_along.IsGiven(arguments) && surfaces.Length == 0) throw Usage("--infill-along goes with --surface.");
        if (arguments.GetValue(_blend) is { } blend)
        {
            if (kind != "vertical" || surfaces.Length == 0) throw Usage("--blend goes with --surface and --field vertical.");
            _ = Blend(blend);
        }
        _onto.Check(arguments, !HasField(arguments));
    }

    /// <summary>The field of the layers, and the uppermost surface that it follows, if it does.</summary>
    /// <param name="arguments">The command line.</param>
    /// <param name="models">The models where they are printed.</param>
    /// <param name="shift">How far they were moved from their places in their files.</param>
    /// <param name="setup">Its head limits overhangs.</param>
    /// <param name="session">Reads files.</param>
    public LayerField Field(
        ParseResult arguments, IReadOnlyList<NamedMesh> models, Vec3 shift, PrintSetup setup, Session session, out PlanSurface? surface)
    {
        surface = null;
        if (arguments.GetValue(_deform) is { } deform) return Deformed(deform, models, shift, setup, session);
        var surfaces = arguments.GetValue(_surface) ?? [];
        var kind = arguments.GetValue(_field) ?? "vertical";
        if (IsBetweenEnds(kind, surfaces))
        {
            var part = models.Count == 1 ? models[0].Mesh : TriMesh.Merge(models.Select(m => m.Mesh));
            var ends = _boundaries.Of(arguments, part, shift, session);
            return kind == "geodesic" ? LayerField.Geodesic(ends, session.Cancel) : LayerField.Harmonic(ends, session.Cancel);
        }
        switch (kind)
        {
            case "vertical":
                surface = Surface(surfaces[0], models, shift, session);
                return LayerField.Vertical(surface, arguments.GetValue(_blend) is { } blend ? Blend(blend) : null);
            case "normal":
                var mesh = Meshes.ReadAsOne(surfaces[0], session).Moved(shift);
                surface = PlanSurface.Of(mesh);
                return LayerField.Offset(mesh);
            case "between":
                var plans = surfaces.Select(s => Surface(s, models, shift, session)).ToList();
                // One surface: from the bottom of the models up to it.
                if (plans.Count == 1) plans.Insert(0, PlanSurface.Level(models.Min(m => m.Mesh.Bounds.Min.Z)));
                surface = plans[^1];
                return LayerField.Between(plans.ToArray());
            case var formula:
                return session.ValueOrFail(LayerField.Formula(formula, shift, new SourceLocation(Key: "--field")), ExitCode.Usage);
        }
    }

    /// <summary>The object that is printed on; none where it was not given.</summary>
    /// <param name="arguments">The command line.</param>
    /// <param name="shift">How far the models were moved in x and y.</param>
    /// <param name="session">Reads files.</param>
    public TriMesh? Onto(ParseResult arguments, Vec3 shift, Session session) => _onto.Read(arguments, shift, session);

    /// <summary>Lines that take the place of the infill's pattern, along directions of a surface; null for the pattern.</summary>
    /// <inheritdoc cref="Field" path="/param"/>
    public IReadOnlyList<Polyline>? InfillLines(
        ParseResult arguments, PlanSurface? surface, IReadOnlyList<NamedMesh> models, Vec3 shift, PrintSetup setup, Session session)
        => surface is null ? null : _along.Lines(arguments, surface, models, shift, setup, session);

    public double Squeeze(ParseResult arguments) => _onto.Squeeze(arguments);

    /// <summary>How the tool is tilted; null where it stays upright.</summary>
    public ToolTilt? Tilt(ParseResult arguments)
    {
        if (arguments.GetValue(_tilt) is not { } text) return null;
        var (word, number) = text.Split('=', 2) is [var w, var n] ? (w.Trim(), n) : (text.Trim(), "90");
        if (word is not ("bc" or "ac") || Numbers.List(number, "--tilt") is not [var most and > 0 and <= 90])
            throw Usage("--tilt needs bc or ac, or one of them with an angle of 0 to 90 degrees: bc=45.");
        return new ToolTilt(word == "bc" ? TiltAxes.BC : TiltAxes.AC, most);
    }

    // Between surfaces, or between ends of the model itself.
    private static bool IsBetweenEnds(string kind, string[] surfaces) => kind is "harmonic" or "geodesic" || (kind == "between" && surfaces.Length == 0);

    private static LayerField Deformed(string text, IReadOnlyList<NamedMesh> models, Vec3 shift, PrintSetup setup, Session session)
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
            return session.ValueOrFail(LayerField.Deformed(x, y, z, shift, new SourceLocation(Key: "--deform")), ExitCode.Usage);
        throw Usage("--deform needs cone=DEGREES, overhangs, overhangs=DEGREES, or three formulas \"X; Y; Z\".");
    }

    private static double Degrees(string text)
        => Numbers.List(text, "--deform") is [var degrees and >= -80 and <= 80] ? degrees : throw Usage("--deform needs an angle of −80 to 80 degrees.");

    private static PlanSurface Surface(string text, IReadOnlyList<NamedMesh> models, Vec3 shift, Session session)
    {
        if (text.LastIndexOf(':') is > 1 and var colon && IsImage(text[..colon]))
        {
            if (Numbers.List(text[(colon + 1)..], "--surface") is not [var low, var high]
                || !(high >= low))
            {
                throw Usage("A height map needs FILE:LOW,HIGH in mm.");
            }
            var image = session.ValueOrFail(ImageReader.Read(session.ReadBytes(text[..colon]), text[..colon]));
            var bounds = Bounds.Of(models.SelectMany(m => new[] { m.Mesh.Bounds.Min, m.Mesh.Bounds.Max }));
            return PlanSurface.HeightMap(image, new Bounds(bounds.Min.WithZ(low + shift.Z), bounds.Max.WithZ(high + shift.Z)));
        }
        if (IsImage(text)) throw Usage("A height map needs the heights of black and white: FILE:LOW,HIGH in mm.");
        if (MeshEndings.Any(e => text.EndsWith(e, StringComparison.OrdinalIgnoreCase)) || File.Exists(text))
            return PlanSurface.Of(Meshes.ReadAsOne(text, session).Moved(shift));
        return session.ValueOrFail(PlanSurface.Formula(text, new SourceLocation(Key: "--surface")), ExitCode.Usage).Moved(shift);
    }

    private static bool IsImage(string file)
        => file.EndsWith(".png", StringComparison.OrdinalIgnoreCase) || file.EndsWith(".pgm", StringComparison.OrdinalIgnoreCase);

    private static LayerBlend Blend(string text) => Numbers.List(text, "--blend") switch
    {
        [var to and > 0] => new LayerBlend(0, to),
        [var from and >= 0, var to] when to > from => new LayerBlend(from, to),
        _ => throw Usage("--blend needs the height in mm where layers follow the surface, or that and where they leave the level: FROM,TO."),
    };

    private static CliException Usage(string message) => new(ExitCode.Usage, message);
}
