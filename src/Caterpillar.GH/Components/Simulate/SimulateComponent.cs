namespace Caterpillar.GH.Components.Simulate;

/// <summary>What a position of the simulation means.</summary>
public enum PositionBy
{
    Time,
    Length,
    Layer,
    Seconds,
    LayerNumber,
    Line,
}

/// <summary>Shows the machine at a moment of a print.</summary>
public sealed class SimulateComponent() : CaterpillarComponent(
    "Simulate", "Sim", "Shows the machine at a moment of the print: print head, direction of motion, and extrusions so far. Connect a slider or Play to "
        + "Position.", Panel.Simulate)
{
    private static readonly Color Printed = Color.FromArgb(240, 136, 62);
    private static readonly Color HeadColor = Color.FromArgb(60, 70, 80);
    public override Guid ComponentGuid => new("b1d0a8a4-57f3-4c0e-a0d5-93c1f4e3c701");

    private protected override bool DrawsItself => true;

    private protected override void Inputs(InputPorts ports)
    {
        ports.Toolpath();
        ports.Number("Position", "t", "Position in the print, from 0 to 1 or in another Position Unit.", 1);
        ports.Choice("Position Unit", "U", "Unit of Position. Time, Length, Layer: from 0 to 1. Seconds: time. Layer Number: as in the file. Line: line of the "
            + "file, from 1, or step of the design, from 0.", PositionBy.Time);
    }

    private protected override void Outputs(OutputPorts ports)
    {
        ports.Add(new Param_Plane(), "Plane", "Pl", "Plane at the nozzle tip, with X along the motion.");
        ports.Add(new ToolpathParam { Hidden = true }, "Printed", "Pr", "Toolpath up to the position, made only if it is used.");
        ports.Add(new Param_Curve { Hidden = true }, "Current", "C", "Current move up to the position. Null if none.");
        ports.Number("Time", "Ti", "Time since the start, in seconds.");
        ports.Integer("Line", "L", "Line number in the file, from 1, or number of the step in the design, from 0. -1 = none.");
        ports.Add(new Param_Curve { Hidden = true }, "Head", "H", "Outline of the print head above the nozzle.");
        ports.Text("State", "S", "State of the machine as text.");
        ports.Add(new Param_Mesh { Hidden = true }, "Head Mesh", "HM", "Mesh of the nozzle and the print head. Null if the printer has no head shape.");
    }

    private protected override void Solve(Run run)
    {
        var position = run.Finite(1);
        var by = run.Choice<PositionBy>(2);
        if (by <= PositionBy.Layer && position is < 0 or > 1) throw new InputProblem("Position must be from 0 to 1.");
        var goo = run.Get<ToolpathGoo>(0);
        var toolpath = goo.Value;
        if (toolpath.Count == 0) throw new InputProblem("The toolpath has no moves.");
        var setup = SetupPort.Of(run, -1, goo);
        var units = run.Units;
        var timeline = run.Work("Timing", [toolpath, setup], (progress, cancel) => Timeline.Of(toolpath, setup, progress, cancel));
        var lines = run.Work("Drawing", [toolpath, units.ToMillimeters], (_, cancel) => PrintedLines.Of(toolpath, units, cancel));
        var state = StateAt(timeline, position, by);
        lines.ShowUntil(state.Move, state.Done);
        var outline = run.Cached([setup.Printer, units.ToMillimeters], () => new HeadOutline(setup.Printer, units));
        var head = outline.At(state.Head, state.Frame.WithOrigin(state.Position));
        var box = lines.Box;
        foreach (var line in head) box.Union(line.BoundingBox);
        run.Show(new Shown(lines, head, box));

        run.SetAll(RhinoGeometry.ToPlane(state.Frame, units), goo.Until(state.Move, state.Position, state.Done), Current(timeline, state, units), state.Time,
            state.Source, outline.ProfileAt(state.Head), Words(timeline, state), outline.MeshAt(state.Head));
        run.Summarize($"{NumberFormatter.Format(100 * (timeline.Duration > 0 ? state.Time / timeline.Duration : 1), 1)} %");
    }

    private static MachineState StateAt(Timeline timeline, double position, PositionBy by)
    {
        if (by == PositionBy.Time) return timeline.AtFraction(position);
        if (by == PositionBy.Length) return timeline.AtLength(position);
        if (by == PositionBy.Seconds) return timeline.At(position);
        if (by != PositionBy.Layer) return AtNumber(timeline, position, by) ?? throw new InputProblem("The toolpath has no such layer, line or step.");
        var layers = timeline.Toolpath.Layers.Count;
        if (layers == 0 || position >= 1) return timeline.AtFraction(position);
        // Within a layer by time.
        var layer = Math.Min((int)(position * layers), layers - 1);
        var from = timeline.AtLayer(layer)?.Time ?? 0;
        var to = layer + 1 < layers ? timeline.AtLayer(layer + 1)?.Time ?? timeline.Duration : timeline.Duration;
        return timeline.At(from + (position * layers - layer) * (to - from));
    }

    // The beginning of a layer or of a line.
    private static MachineState? AtNumber(Timeline timeline, double position, PositionBy by)
    {
        var number = (int)Math.Floor(Math.Max(Math.Min(position, int.MaxValue), -1));
        return by != PositionBy.Line ? timeline.AtLayerNumber(number) : number >= 0 ? timeline.AtSource(number) : null;
    }

    private static Rg.Curve? Current(Timeline timeline, MachineState state, DocumentUnits units)
    {
        if (state.Move >= timeline.Toolpath.Count || state.Done <= 0) return null;
        var move = timeline.Toolpath[state.Move];
        if (move.Arc is null) return PolylineMaker.Of([RhinoGeometry.ToPoint(move.Start, units), RhinoGeometry.ToPoint(state.Position, units)]);
        var points = Enumerable.Range(0, 33).Select(k => RhinoGeometry.ToPoint(move.Arc.Value.PointAt(move.Start, move.End, state.Done * k / 32), units));
        return PolylineMaker.Of(points);
    }

    private static string Words(Timeline timeline, MachineState state)
    {
        string N(double value, int decimals) => NumberFormatter.Format(value, decimals);
        if (state.Move >= timeline.Toolpath.Count) return $"Finished after {N(state.Time, 1)} s.";
        var what = state.Waits ? "Waiting" : state.Kind.ToString();
        var role = state.Role == Toolpaths.Role.Unspecified ? "" : $", {ChoiceParam.Spaced(state.Role.ToString()).ToLowerInvariant()},";
        var flow = state.Flow is { } f ? $", {N(f, 2)} mm³/s" : "";
        return $"{what}{role} at {N(state.Speed, 1)} mm/s{flow}, move {N(state.Move, 0)} of {N(timeline.Toolpath.Count, 0)}, {N(state.TimeLeft, 1)} s left, "
            + $"nozzle {N(state.NozzleTemperature, 0)} °C";
    }

    private sealed record Shown(PrintedLines Lines, Rg.Line[] Head, Rg.BoundingBox Box) : IDrawn
    {
        public void DrawWires(IGH_PreviewArgs args, bool selected)
        {
            Lines.Draw(args.Display, selected ? args.WireColour_Selected : Printed, 2);
            args.Display.DrawLines(Head, selected ? args.WireColour_Selected : HeadColor, 2);
        }

        public void DrawMeshes(IGH_PreviewArgs args, bool selected)
        {
        }
    }
}
