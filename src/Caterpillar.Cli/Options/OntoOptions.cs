namespace Caterpillar.Cli;

/// <summary>Options for an object on the bed that is printed on.</summary>
/// <param name="does">Description of <c>--onto</c>.</param>
internal sealed class OntoOptions(string does = OntoOptions.Drawn)
{
    private const string Drawn
        = "Object to print onto, such as a scanned mesh, at its position in the file. Heights above the bed become heights above its surface.";

    private readonly Described<string?> _onto = new("--onto", does, "FILE");

    private readonly Described<double> _squeeze = new("--squeeze", "With --onto: distance by which the first extrusions are pressed into the object.", "MM");

    private readonly Described<bool> _partial = new("--partial", "Skip parts that are beyond the surface or too steep, instead of refusing the print.");

    private readonly Described<bool> _inPlace = new("--in-place", "With --onto: leave paths where they are drawn, for example on the side of the object.");

    public Option[] All => [_onto, _squeeze, _partial];

    /// <summary>For drawings, which may lie on the side of the object, too.</summary>
    public Option[] OfDrawings => [.. All, _inPlace];

    public bool IsGiven(ParseResult arguments) => arguments.GetValue(_onto) is not null;

    /// <summary>Finds wrong usage before files are read.</summary>
    /// <param name="arguments">The command line.</param>
    /// <param name="alone">Whether paths follow the object alone, and no other surface.</param>
    /// <exception cref="CliException">Options cannot be combined.</exception>
    public void Check(ParseResult arguments, bool alone = true)
    {
        var squeeze = arguments.GetValue(_squeeze);
        if (squeeze is not (>= 0 and < 10)) throw CliException.Usage("--squeeze needs a distance of 0 to 10 mm.");
        if (alone && !IsGiven(arguments) && (squeeze > 0 || arguments.GetValue(_partial))) throw CliException.Usage("--squeeze and --partial need --onto.");
        if (arguments.GetValue(_inPlace) && (!IsGiven(arguments) || squeeze > 0 || arguments.GetValue(_partial)))
            throw CliException.Usage("--in-place needs --onto, and cannot be combined with --squeeze or --partial.");
        if (!alone && squeeze > 0) throw CliException.Usage("--squeeze cannot be combined with --surface, --field or --deform.");
    }

    /// <summary>Options of a print with the object at its position, if one is given.</summary>
    /// <param name="arguments">The command line.</param>
    /// <param name="placed">Transforms of the models from the positions in their files. The object stays on the bed; there is one for each copy.</param>
    /// <param name="options">The other options.</param>
    /// <param name="session">Reads its file, and prints where the object must be.</param>
    /// <exception cref="CliException">It cannot be read, is tilted, or overlaps that of another copy.</exception>
    public PrintJobOptions Of(ParseResult arguments, IReadOnlyList<Affine> placed, PrintJobOptions options, Session session)
    {
        options = options with { Squeeze = arguments.GetValue(_squeeze), Partial = arguments.GetValue(_partial), InPlace = arguments.GetValue(_inPlace) };
        if (arguments.GetValue(_onto) is not { } file) return options;
        if (placed.Any(map => !map.IsUpright)) throw CliException.Usage("--onto: the object on the bed cannot be rotated about X and Y with the model.");
        var mesh = Meshes.ReadAsOne(file, session);
        var objects = placed.Select(map => mesh.Transformed(map with { Shift = map.Shift.WithZ(0) })).ToArray();
        session.Print(objects.Select(o => Place(o, file)).ToArray());
        if (objects.Any(a => objects.Any(b => a != b && a.Bounds.Overlaps(b.Bounds))))
            throw CliException.Usage("--onto: the objects of the copies would overlap. Increase --spacing.");
        return options with { Onto = TriMesh.Merge(objects) };
    }

    /// <summary>The print of a drawing, on the object if one is given.</summary>
    /// <exception cref="CliException">It cannot be planned.</exception>
    public PrintJob Draw(ParseResult arguments, IReadOnlyList<Step> steps, PrintSetup setup, PrintJobOptions options, Session session)
    {
        options = Of(arguments, [Affine.Identity], options, session);
        return session.Run("Planning", progress => PrintJob.Draw(steps, setup, options, progress, session.Cancel));
    }

    // Where the object has to be.
    private static Diagnostic Place(TriMesh mesh, string file)
    {
        var (low, high) = (mesh.Bounds.Min, mesh.Bounds.Max);
        return new Diagnostic(Severity.Note, "curved.object_place",
            $"Place the object at X {Text(low.X)} to {Text(high.X)}, Y {Text(low.Y)} to {Text(high.Y)}, Z {Text(low.Z)} to {Text(high.Z)} mm.",
            new SourceLocation(Session.NameOf(file)));
    }

    private static string Text(double value) => NumberFormatter.Format(value, 2);
}
