namespace Caterpillar.GH.Components.Design;

/// <summary>Runs turtle programs.</summary>
public sealed class TurtleComponent() : CaterpillarComponent(
    "Turtle", "Turtle", "Runs a turtle program. Gives its print paths, and all steps in order for planning.", Panel.Design)
{
    public override Guid ComponentGuid => new("4d9e2c17-86ab-4f50-b3e1-7c05d8a9f264");

    private protected override void Inputs(InputPorts ports)
    {
        ports.Add(new TurtleProgramParam(), "Program", "P", "Turtle program, or its script as text.");
        ports.Setup("Its maximum Z speed, filament and bead shape are used. Default: as the script states (use), or generic.");
        ports.Add(new Param_Plane(), "Start Plane", "Pl", "Start pose of the turtle: X points forward, Y left. Default: World XY.", optional: true);
        ports.Bead("Commands of the program change it. Default: 0.05 mm of filament per mm.");
        ports.Boolean("Every Pose", "E", "Give the pose and triangle after every command, not only the last.", false);
    }

    private protected override void Outputs(OutputPorts ports)
    {
        ports.Add(new PrintPathParam(), "Print Paths", "P", "Print paths, in order.", GH_ParamAccess.list);
        ports.Add(new StepParam(), "Steps", "S", "Print paths, travel moves and events, in order, for Plan Toolpath.", GH_ParamAccess.list);
        ports.Add(new Param_Plane(), "Planes", "Pl", "Poses of the turtle.", GH_ParamAccess.list);
        ports.Curve("Triangles", "T", "Turtle as triangles that point forward.", GH_ParamAccess.list);
        ports.Diagnostics();
    }

    private protected override void Solve(Run run)
    {
        var program = run.Get<TurtleProgram>(0);
        var units = run.Units;
        var setup = SetupOf(program, run);
        var options = TurtleOptions.For(setup) with
        {
            Start = run.FrameOf(2),
            KeepPoses = run.Get<bool>(4),
            Bead = run.Maybe<BeadGoo>(3) is { IsValid: true } bead ? bead.Value : null,
        };
        var result = run.Work("Running", [program, setup, options.Start, options.KeepPoses, options.Bead], (progress, cancel) =>
        {
            var done = program.Run(options, null, progress, cancel);
            return new Done(done.Value?.ToSteps() ?? [], done.Value is null ? [] : options.KeepPoses ? done.Value.Poses : [done.Value.Pose], done.Diagnostics);
        });
        run.Report(result.Diagnostics);
        run.SetList(0, result.Steps.OfType<PathStep>().Select(s => new PrintPathGoo(s, setup)));
        run.SetList(1, result.Steps.Select(s => new StepGoo(s, setup)));
        run.SetList(2, result.Poses.Select(p => RhinoGeometry.ToPlane(p, units)));
        run.SetList(3, result.Poses.Select(p => TurtleShape.Outline(p, 2, units)));
    }

    // The port first, then what the script names, then what the printer names.
    private static PrintSetup SetupOf(TurtleProgram program, Run run)
    {
        var named = program.Profiles;
        if (named.Count == 0 || run.Maybe<PrintSetup>(1) is not null) return SetupPort.Of(run, 1);
        return run.Require(Profiles.Library.Setup(named[0] ?? "generic", named.ElementAtOrDefault(1), named.ElementAtOrDefault(2)));
    }

    private sealed record Done(IReadOnlyList<Step> Steps, IReadOnlyList<Frame> Poses, IReadOnlyList<Basics.Diagnostic> Diagnostics);
}
