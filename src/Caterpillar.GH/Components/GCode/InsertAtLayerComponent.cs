namespace Caterpillar.GH.Components.GCode;

/// <summary>Events to insert before a layer.</summary>
public enum LayerEventKind
{
    Pause,
    Tool,
    NozzleTemperature,
    BedTemperature,
    Fan,
    Dwell,
    Comment,
    RawLine,
}

/// <summary>Inserts pauses, tool changes and other events before layers.</summary>
public sealed class InsertAtLayerComponent() : CaterpillarComponent(
    "Insert At Layer", "Insert", "Inserts a pause, a tool change, a temperature or a line of G-code before layers of a toolpath.", Panel.GCode,
    GH_Exposure.tertiary)
{
    public override Guid ComponentGuid => new("b4c1e0d7-58a2-4f6b-9e31-7d90a2c4f615");

    private protected override void Inputs(InputPorts ports)
    {
        ports.Toolpath();
        ports.Integer("Layers", "L", "Layer numbers, from 0. The event is inserted before each of these layers.", access: GH_ParamAccess.list);
        ports.Choice("Kind", "K", "Kind of event.", LayerEventKind.Pause);
        ports.Number("Value", "V", "Tool number, temperature in °C, fan speed from 0 to 1, or seconds.", 0);
        ports.Text("Text", "Tx", "Message of a pause, comment, or line of G-code.", "");
    }

    private protected override void Outputs(OutputPorts ports) => ports.Add(new ToolpathParam(), "Toolpath", "T", "Toolpath with what is inserted.");

    private protected override void Solve(Run run)
    {
        var goo = run.Get<ToolpathGoo>(0);
        var what = Event(run);
        var layers = run.List<GH_Integer>(1).Select(l => l.Value).ToArray();
        var edited = run.Work("Inserting", [goo.Value, what, string.Join(" ", layers)], (_, cancel) => Insert(goo.Value, layers, what, cancel));
        foreach (var problem in edited.Problems) run.Report(GH_RuntimeMessageLevel.Warning, problem);
        run.Set(0, goo.With(edited.Toolpath));
    }

    private static Edited Insert(Toolpath toolpath, int[] layers, PrinterEvent what, CancellationToken cancel)
    {
        var problems = new List<string>();
        foreach (var layer in layers)
        {
            cancel.ThrowIfCancellationRequested();
            var changed = toolpath.InsertAtLayer(layer, what);
            if (changed.Value is null) problems.Add(changed.Diagnostics[0].Message);
            toolpath = changed.Value ?? toolpath;
        }
        return new Edited(toolpath, problems);
    }

    private static PrinterEvent Event(Run run)
    {
        var text = run.Maybe<string>(4) ?? "";
        double Value(double most, string meaning) => run.Within(3, 0, most, meaning);
        return run.Choice<LayerEventKind>(2) switch
        {
            LayerEventKind.Pause => new PauseEvent(text),
            LayerEventKind.Tool => new ToolEvent(Value(99, "a tool number from 0 to 99") is var tool
                && tool == Math.Floor(tool) ? (int)tool : throw new InputProblem("Value must be a tool number from 0 to 99.")),
            LayerEventKind.NozzleTemperature => new NozzleTemperatureEvent(Value(600, "a temperature from 0 to 600 °C"), Wait: true),
            LayerEventKind.BedTemperature => new BedTemperatureEvent(Value(300, "a temperature from 0 to 300 °C"), Wait: true),
            LayerEventKind.Fan => new FanEvent(Value(1, "a fan speed from 0 to 1")),
            LayerEventKind.Dwell => new DwellEvent(Value(1e6, "a number of seconds from 0 to 1000000")),
            LayerEventKind.Comment => new CommentEvent(text),
            _ => new RawEvent(text.Trim().Length > 0 ? text : throw new InputProblem("Text is missing.") { IsMissing = true }),
        };
    }

    private sealed record Edited(Toolpath Toolpath, IReadOnlyList<string> Problems);
}
