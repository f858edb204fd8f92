using Caterpillar.Curved;
using Caterpillar.Jobs;

namespace Caterpillar.Cli;

/// <summary>Options for an object that lies on the bed and is printed on.</summary>
/// <param name="does">What happens with the object.</param>
/// <param name="leavesOut">What is left out of a partial print.</param>
internal sealed class OntoOptions(string does, string leavesOut)
{
    /// <summary>What drawn toolpaths do on an object.</summary>
    public const string Drawn = "Print onto an object, a scanned mesh for example, that lies on the bed where its file says: heights above the bed become "
        + "heights above its surface.";

    /// <summary>What is left out of drawn toolpaths.</summary>
    public const string DrawnPartial = "With --onto: leave out what lies beyond the object or is too steep.";

    private readonly Described<string?> _onto = new("--onto", does, "SCAN");

    private readonly Described<double> _squeeze = new("--squeeze", "With --onto: how much the first extrusions are pressed onto the object, mm.", "MM");

    private readonly Described<bool> _partial = new("--partial", leavesOut);

    public Option[] All => [_onto, _squeeze, _partial];

    public bool IsGiven(ParseResult arguments) => arguments.GetValue(_onto) is not null;

    public bool IsPartial(ParseResult arguments) => arguments.GetValue(_partial);

    public double Squeeze(ParseResult arguments) => arguments.GetValue(_squeeze);

    /// <summary>Wrong usage is found before files are read.</summary>
    /// <param name="arguments">The command line.</param>
    /// <param name="alone">Whether the object is all that paths follow.</param>
    /// <exception cref="CliException">Options do not go together.</exception>
    public void Check(ParseResult arguments, bool alone = true)
    {
        if (Squeeze(arguments) is not (>= 0 and < 10)) throw Usage("--squeeze needs a distance of 0 to 10 mm.");
        if (alone && !IsGiven(arguments) && (Squeeze(arguments) > 0 || IsPartial(arguments))) throw Usage("--squeeze and --partial go with --onto.");
        if (!alone && Squeeze(arguments) > 0) throw Usage("--squeeze goes with --onto alone.");
    }

    /// <summary>The object where it lies; null where none was given.</summary>
    /// <param name="arguments">The command line.</param>
    /// <param name="shift">How far it is moved, with the models.</param>
    /// <param name="session">Reads its file, and says where the object is expected.</param>
    public TriMesh? Read(ParseResult arguments, Vec3 shift, Session session)
    {
        if (arguments.GetValue(_onto) is not { } file) return null;
        var mesh = Meshes.ReadAsOne(file, session).Moved(shift.WithZ(0));
        session.Print([Place(mesh, file)]);
        return mesh;
    }

    /// <summary>The print of a drawing, on the object where one was given.</summary>
    /// <exception cref="CliException">It cannot be planned.</exception>
    public PrintJob Draw(ParseResult arguments, IReadOnlyList<Step> steps, PrintSetup setup, PrintJobOptions options, Session session)
    {
        options = options with { Onto = Read(arguments, Vec3.Zero, session), Squeeze = Squeeze(arguments), Partial = IsPartial(arguments) };
        return session.Run("Planning", progress => PrintJob.Draw(steps, setup, options, progress, session.Cancel));
    }

    // Where the object has to lie.
    private static Diagnostic Place(TriMesh mesh, string file)
    {
        var (low, high) = (mesh.Bounds.Min, mesh.Bounds.Max);
        return new Diagnostic(Severity.Note, "curved.object_place",
            $"The object is expected at x {Text(low.X)} to {Text(high.X)}, y {Text(low.Y)} to {Text(high.Y)}, z {Text(low.Z)} to {Text(high.Z)} mm.",
            new SourceLocation(Session.NameOf(file)));
    }

    private static string Text(double value) => NumberFormatter.Format(value, 2);

    private static CliException Usage(string message) => new(ExitCode.Usage, message);
}
