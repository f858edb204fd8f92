using Caterpillar.Geometry;
using Caterpillar.GH.Base;
using Caterpillar.GH.Conversion;
using Caterpillar.GH.Goos;
using Caterpillar.GH.Params;
using Caterpillar.GH.Plugin;
using Caterpillar.Machines;
using Caterpillar.Toolpaths;
using Caterpillar.Turtles;
using Grasshopper.Kernel;
using Grasshopper.Kernel.Parameters;

namespace Caterpillar.GH.Components.Design;

/// <summary>Runs turtle programs.</summary>
public sealed class TurtleComponent() : CaterpillarComponent(
    "Turtle", "Turtle", "Runs a turtle program: print paths, and all steps in order for planning.", Panel.Design)
{
    public override Guid ComponentGuid => new("4d9e2c17-86ab-4f50-b3e1-7c05d8a9f264");

    private protected override void Inputs(InputPorts ports)
    {
        ports.Add(new TurtleProgramParam(), "Program", "P", "Program to run; text is read as a script.");
        ports.Add(new Param_Plane(), "Start Plane", "Pl",
            "Initial pose of the turtle, in document units: X is forward, Y left. World XY by default.", optional: true);
        ports.Add(new BeadParam(), "Bead", "B", "Initial extrusion, instead of 0.05 mm of filament per mm; commands of the program change it.", optional: true);
        ports.Number("Filament Diameter", "D", "Diameter of the filament, in mm, which turns mm of filament into extrusions.", 1.75);
        ports.Boolean("Every Pose", "E", "True gives the pose and triangle after every command, false only the last.", false);
        ports.Add(new PrinterParam(), "Printer", "Pr",
            "Printer, or the name of its profile, whose Z axis limits drawn lifts; by default the one that the script names (use), or generic.",
            optional: true);
        ports.Add(new MaterialParam(), "Material", "M",
            "Material, or the name of its profile, whose filament and flow are used; by default the one that the script names, or Filament Diameter.",
            optional: true);
        ports.Add(new SettingsParam(), "Settings", "Se",
            "Print settings, or the name of their profile, which state the shape of beads; by default those that the script names, or those of the printer.",
            optional: true);
    }

    private protected override void Outputs(OutputPorts ports)
    {
        ports.Add(new PrintPathParam(), "Print Paths", "P", "What is deposited, in order.", GH_ParamAccess.list);
        ports.Add(new StepParam(), "Steps", "S", "Paths, drawn travels and events, in order.", GH_ParamAccess.list);
        ports.Add(new Param_Plane(), "Planes", "Pl", "Poses of the turtle, in document units.", GH_ParamAccess.list);
        ports.Curve("Triangles", "T", "The turtle as triangles that point forward, in document units.", GH_ParamAccess.list);
        ports.Diagnostics();
        ports.Add(new PrinterParam(), "Printer", "Pr", "The printer of the program, for planning.");
        ports.Add(new MaterialParam(), "Material", "M", "The material of the program, for planning.");
        ports.Add(new SettingsParam(), "Settings", "Se", "The print settings of the program, for planning.");
    }

    private protected override void Solve(Run run)
    {
        var program = run.Get<TurtleProgram>(0);
        var units = run.Units;
        var setup = SetupOf(program, run);
        var options = TurtleOptions.For(setup) with
        {
            Start = run.FrameOf(1),
            KeepPoses = run.Get<bool>(4),
            Bead = run.Maybe<BeadGoo>(2) is { IsValid: true } bead ? bead.Value : null,
        };
        var result = run.Work("Turtle", [program, setup, options.Start, options.KeepPoses, options.Bead], (progress, cancel) =>
        {
            var done = program.Run(options, null, progress, cancel);
            return new Done(done.Value?.ToSteps() ?? [], done.Value is null ? [] : options.KeepPoses ? done.Value.Poses : [done.Value.Pose], done.Diagnostics);
        });
        run.Report(result.Diagnostics);
        run.Set(5, new PrinterGoo(setup.Printer));
        run.Set(6, new MaterialGoo(setup.Material));
        run.Set(7, new SettingsGoo(setup.Settings));
        run.SetList(0, result.Steps.OfType<PathStep>().Select(s => new PrintPathGoo(s.Path)));
        run.SetList(1, result.Steps.Select(s => new StepGoo(s)));
        run.SetList(2, result.Poses.Select(p => RhinoGeometry.ToPlane(p, units)));
        run.SetList(3, result.Poses.Select(p => TurtleShape.Outline(p, 2, units)));
    }

    // The ports first, then what the script names, then what the printer names.
    private static PrintSetup SetupOf(TurtleProgram program, Run run)
    {
        var library = Profiles.Library;
        var named = program.Profiles;
        var given = run.Maybe<Material>(6);
        var printer = run.Maybe<Printer>(5) ?? run.Require(library.Printer(named.ElementAtOrDefault(0) ?? "generic"));
        var material = given ?? run.Accept(library.Material(named.ElementAtOrDefault(1) ?? printer.DefaultMaterial));
        var settings = run.Maybe<PrintSettings>(7) ?? run.Accept(library.Settings(named.ElementAtOrDefault(2) ?? printer.DefaultSettings));
        if (material is null || settings is null) throw new NoResult();
        // Definitions without a material state the diameter of the filament alone.
        var diameter = run.Positive(3);
        if (given is null && named.Count == 0) material = material with { FilamentDiameter = diameter };
        return new PrintSetup(printer, material, settings);
    }

    private sealed record Done(IReadOnlyList<Step> Steps, IReadOnlyList<Frame> Poses, IReadOnlyList<Basics.Diagnostic> Diagnostics);
}
