using System;
using System.Collections.Generic;
using System.Linq;
using Caterpillar.GH.Base;
using Caterpillar.GH.Conversion;
using Caterpillar.GH.Goos;
using Caterpillar.GH.Params;
using Caterpillar.Geometry;
using Caterpillar.Machines;
using Caterpillar.Toolpaths;
using Caterpillar.Turtles;
using Grasshopper.Kernel;
using Grasshopper.Kernel.Parameters;

namespace Caterpillar.GH.Components.Design;

/// <summary>Runs turtle programs.</summary>
public sealed class TurtleComponent()
    : CaterpillarComponent("Turtle", "Turtle", "Runs a turtle program: print paths, and all steps in order for planning.", Panel.Design)
{
    public override Guid ComponentGuid => new("b7f06a52-91de-4f7b-8a2a-40d9c55f3c12");

    private protected override void Inputs(InputPorts ports)
    {
        ports.Add(new TurtleProgramParam(), "Program", "P", "Program to run; text is read as a script.");
        ports.Add(new Param_Plane(), "Start Plane", "Pl",
            "Initial pose of the turtle, in document units: X is forward, Y left. World XY by default.", optional: true);
        ports.Number("Filament Diameter", "D", "Diameter of the filament, in mm, which turns mm of filament into strands.", 1.75);
        ports.Boolean("Every Pose", "E", "True gives the pose and triangle after every command, false only the last.", false);
        ports.Add(new BeadParam(), "Bead", "B", "Initial strand, instead of 0.05 mm of filament per mm; commands of the program change it.",
            optional: true);
    }

    private protected override void Outputs(OutputPorts ports)
    {
        ports.Add(new PrintPathParam(), "Print Paths", "P", "What is deposited, in order.", GH_ParamAccess.list);
        ports.Add(new StepParam(), "Steps", "S", "Paths, drawn travels and events, in order.", GH_ParamAccess.list);
        ports.Add(new Param_Plane(), "Planes", "Pl", "Poses of the turtle, in document units.", GH_ParamAccess.list);
        ports.Curve("Triangles", "T", "The turtle as triangles that point forward, in document units.", GH_ParamAccess.list);
        ports.Diagnostics();
    }

    private protected override void Solve(Run run)
    {
        var program = run.Get<TurtleProgram>(0);
        var units = run.Units;
        var options = new TurtleOptions
        {
            Start = run.MaybeValue<Rg.Plane>(1) is { } plane ? RhinoGeometry.ToFrame(plane, units) : Frame.World,
            Extrusion = new ExtrusionModel(ExtrusionUnit.Mm, run.Positive(2)),
            KeepPoses = run.Get<bool>(3),
            Bead = run.Maybe<BeadGoo>(4) is { IsValid: true } bead ? bead.Value : null,
        };
        var result = run.Cached([program, options.Start, options.Extrusion.FilamentDiameter, options.KeepPoses, options.Bead],
            () => run.Work("Turtle", (progress, cancel) =>
        {
            var done = program.Run(options, null, progress, cancel);
            return new Done(done.Value?.ToSteps() ?? [], done.Value is null ? [] : options.KeepPoses ? done.Value.Poses : [done.Value.Pose], done.Diagnostics);
        }));
        run.SetList(4, run.Report(result.Diagnostics));
        run.SetList(0, result.Steps.OfType<PathStep>().Select(s => new PrintPathGoo(s.Path)));
        run.SetList(1, result.Steps.Select(s => new StepGoo(s)));
        run.SetList(2, result.Poses.Select(p => RhinoGeometry.ToPlane(p, units)));
        run.SetList(3, result.Poses.Select(p => TurtleShape.Outline(p, 2, units)));
    }

    private sealed record Done(IReadOnlyList<Step> Steps, IReadOnlyList<Frame> Poses, IReadOnlyList<Basics.Diagnostic> Diagnostics);
}
