using System;
using System.Linq;
using Caterpillar.GH.Base;
using Caterpillar.GH.Conversion;
using Caterpillar.GH.Goos;
using Caterpillar.GH.Params;
using Caterpillar.Geometry;
using Caterpillar.Toolpaths;
using Caterpillar.Traces;
using Grasshopper.Kernel;
using Grasshopper.Kernel.Parameters;

namespace Caterpillar.GH.Components.Design;

/// <summary>Which ends of a helix have reduced flow.</summary>
public enum TraceRamp
{
    None,
    Start,
    End,
    Both,
}

/// <summary>Base of the shapes made of strings: a plane first, then what the shape needs, and a bead.</summary>
public abstract class TraceComponent(string name, string nickname, string description)
    : CaterpillarComponent(name, nickname, description, Panel.Design, GH_Exposure.tertiary)
{
    private protected static void PlanePort(InputPorts ports)
        => ports.Add(new Param_Plane(), "Plane", "Pl",
            "Position of the shape, in document units: its center at the origin, its axis along Z, its start along X. World XY by default.",
            optional: true);

    private protected static void StrandPorts(InputPorts ports)
    {
        ports.Add(new BeadParam(), "Bead", "B", "Strand and speed; by default 0.45 mm wide and 0.2 mm high, at the speed of the print settings.",
            optional: true);
        ports.Integer("Strings Per Turn", "N", "Number of straight strings per turn.", Trace.DefaultStringsPerTurn);
    }

    private protected static void RampPorts(InputPorts ports)
    {
        ports.Choice("Ramp", "Ra", "Which end has reduced flow: the gap to the bed grows from nothing along the first turn, and the last turn ends level.",
            TraceRamp.None);
        ports.Number("Minimum Flow", "L", "Flow at the very end of a ramp, from 0 to 1 of the full flow.", 0.2);
    }

    private protected static FlowRamp? RampOf(Run run, int input)
    {
        var ramp = run.Choice<TraceRamp>(input);
        var least = run.Finite(input + 1);
        return ramp == TraceRamp.None ? null : new FlowRamp(least, ramp != TraceRamp.End, ramp != TraceRamp.Start);
    }

    private protected sealed override void Outputs(OutputPorts ports) => ports.Add(new PrintPathParam(), "Print Path", "P", "The strings as one path.");

    /// <summary>Solves with the plane at input 0, and the bead and the strings per turn at two consecutive inputs.</summary>
    private protected static void Build(Run run, int beadInput, object?[] key, Action<Trace, int> draw)
    {
        var frame = run.MaybeValue<Rg.Plane>(0) is { } plane ? RhinoGeometry.ToFrame(plane, run.Units) : Frame.World;
        var bead = run.MaybeValue<Bead>(beadInput) ?? Bead.FromWidth(0.45, 0.2);
        var strings = run.Get<int>(beadInput + 1);
        var path = run.Work("Trace", [frame, bead, strings, key], (_, _) =>
        {
            var trace = new Trace(bead.Area).SetSpeed(bead.Speed);
            draw(trace, strings);
            var path = trace.ToPaths().FirstOrDefault() ?? throw new InputProblem("The shape is smaller than one string.");
            if (bead.Height > 0) path = path.WithBeads(i => new Bead(path.BeadOf(i).Area, bead.Height, bead.Speed));
            return path.Transformed(Affine.FromFrame(frame));
        });
        run.Set(0, new PrintPathGoo(path));
        run.Summarize($"{Basics.NumberFormatter.Format(path.SegmentCount)} strings");
    }
}
