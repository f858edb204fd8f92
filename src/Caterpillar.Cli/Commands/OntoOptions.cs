using System.Collections.Generic;
using System.CommandLine;
using Caterpillar.Basics;
using Caterpillar.Geometry;
using Caterpillar.Machines;
using Caterpillar.Planning;
using Caterpillar.Slicing;
using Caterpillar.Toolpaths;

namespace Caterpillar.Cli.Commands;

/// <summary>Options that put drawn toolpaths onto an object which lies on the bed.</summary>
internal sealed class OntoOptions
{
    private readonly Option<string?> _onto = new("--onto")
    {
        Description = "Print onto an object, a scanned mesh for example, that lies on the bed where its file says: heights above the bed become heights above "
            + "its surface.",
        HelpName = "SCAN",
    };

    private readonly Option<double> _squeeze = new("--squeeze") { Description = "With --onto: how much the first strands are pressed onto the object, mm.",
        HelpName = "MM" };

    private readonly Option<bool> _partial = new("--partial") { Description = "With --onto: leave out what lies beyond the object or is too steep." };

    public void AddTo(Verb verb)
    {
        foreach (var option in new Option[] { _onto, _squeeze, _partial }) verb.Options.Add(option);
    }

    /// <summary>Wrong usage is found before files are read.</summary>
    /// <exception cref="CliException">Options do not go together.</exception>
    public void Check(ParseResult arguments)
    {
        if (arguments.GetValue(_squeeze) is not (>= 0 and < 10)) throw new CliException(ExitCode.Usage, "--squeeze needs a distance of 0 to 10 mm.");
        if (arguments.GetValue(_onto) is null && (arguments.GetValue(_squeeze) > 0 || arguments.GetValue(_partial)))
            throw new CliException(ExitCode.Usage, "--squeeze and --partial go with --onto.");
    }

    /// <summary>The steps on the object, and how they are planned around it; without an object all as it was.</summary>
    public (IReadOnlyList<Step> Steps, PrintSetup Setup, PlanOptions Plan) Apply(
        ParseResult arguments, IReadOnlyList<Step> steps, PrintSetup setup, PlanOptions plan, Session session)
    {
        if (arguments.GetValue(_onto) is not { } file) return (steps, setup, plan);
        var mesh = Meshes.ReadAsOne(file, session);
        session.Print([Place(mesh, file)]);
        var projected = session.ValueOrFail(session.WithProgress("Projecting", progress => SurfaceProjection.Project(
            steps, PlanSurface.Of(mesh), setup, arguments.GetValue(_squeeze), arguments.GetValue(_partial), progress, session.Cancel)));
        return (projected, Over(setup), plan with { Obstacle = mesh });
    }

    /// <summary>Over objects the head is lifted by what lies under its course, unless travels are not lifted at all.</summary>
    public static PrintSetup Over(PrintSetup setup) => setup.Settings.TravelLift != TravelLift.PrintedTop ? setup
        : setup with { Settings = setup.Settings with { TravelLift = TravelLift.Corridor } };

    /// <summary>Where the object has to lie.</summary>
    public static Diagnostic Place(TriMesh mesh, string file)
    {
        var (low, high) = (mesh.Bounds.Min, mesh.Bounds.Max);
        return new Diagnostic(Severity.Remark, "curved.object_place",
            $"The object is expected at x {Text(low.X)} to {Text(high.X)}, y {Text(low.Y)} to {Text(high.Y)}, z {Text(low.Z)} to {Text(high.Z)} mm.",
            new SourceLocation(Session.NameOf(file)));
    }

    private static string Text(double value) => NumberFormatter.Format(value, 2);
}
