namespace Caterpillar.GH.Components.Path;

/// <summary>Kinds of steps between print paths.</summary>
public enum StepKind
{
    Travel,
    NozzleTemperature,
    BedTemperature,
    Fan,
    Tool,
    Dwell,
    Pause,
    Comment,
    RawLine,
}

/// <summary>Makes a travel move or an event.</summary>
public sealed class StepComponent() : ChosenPortsComponent(
    "Step", "Step", "Creates a travel move or an event that happens between print paths. Connect it to Plan Toolpath, in the order of the wires.", Panel.Path,
    GH_Exposure.secondary)
{
    public override Guid ComponentGuid => new("0d5b7c62-91e4-4b3f-8a7d-2f60c8e41b95");

    private protected override void Inputs(InputPorts ports)
    {
        ports.Choice("Kind", "K", "Kind of step.", StepKind.Travel);
        ports.For("Kind", [StepKind.Travel], () =>
        {
            ports.Add(new Param_Point(), "Points", "Pt", "Points to which the head travels, one after the other.", GH_ParamAccess.list);
            ports.Number("Speed", "V", "Travel speed, in mm/s. 0 = travel speed of the print settings.", 0);
        });
        ports.For("Kind", [StepKind.NozzleTemperature, StepKind.BedTemperature], () =>
        {
            ports.Number("Temperature", "T", "Temperature, in °C. 0 = off.", 0);
            ports.Boolean("Wait", "W", "Wait until the temperature is reached.", true);
        });
        ports.For("Kind", [StepKind.Fan], () => ports.Number("Fan Speed", "F", "Speed of the part cooling fan, from 0 to 1.", 1));
        ports.For("Kind", [StepKind.Tool], () => ports.Integer("Tool", "To", "Number of the tool, from 0.", 0));
        ports.For("Kind", [StepKind.Dwell], () => ports.Number("Duration", "D", "Duration, in seconds.", 1));
        ports.For("Kind", [StepKind.Pause, StepKind.Comment, StepKind.RawLine],
            () => ports.Text("Text", "Tx", "Message of a pause, comment, or line of G-code.", ""));
    }

    private protected override void Outputs(OutputPorts ports) => ports.Add(new StepParam(), "Step", "S", "Step for Plan Toolpath.");

    private protected override void Solve(Run run)
    {
        var step = run.Choice<StepKind>(0) switch
        {
            StepKind.Travel => Travel(run),
            StepKind.NozzleTemperature => new NozzleTemperatureEvent(run.Within(run["Temperature"], 0, 600, "a temperature from 0 to 600 °C"), Wait(run)),
            StepKind.BedTemperature => new BedTemperatureEvent(run.Within(run["Temperature"], 0, 300, "a temperature from 0 to 300 °C"), Wait(run)),
            StepKind.Fan => new FanEvent(run.Within(run["Fan Speed"], 0, 1, "a fan speed from 0 to 1")),
            StepKind.Tool => new ToolEvent((int)run.Within(run["Tool"], 0, 99, "a tool number from 0 to 99")),
            StepKind.Dwell => new DwellEvent(run.Within(run["Duration"], 0, 1e6, "a number of seconds from 0 to 1000000")),
            StepKind.Pause => new PauseEvent(run.Get<string>(run["Text"])),
            StepKind.Comment => new CommentEvent(run.Get<string>(run["Text"])),
            _ => (Step)new RawEvent(run.Get<string>(run["Text"]) is var line && line.Trim().Length > 0 ? line : throw run.Missing(run["Text"])),
        };
        run.Set(0, new StepGoo(step));
    }

    private static Step Travel(Run run)
    {
        var units = run.Units;
        var points = run.Some<GH_Point>(run["Points"]).Select(p => RhinoGeometry.ToVec(p, units));
        return new TravelStep(points, run.NotNegative(run["Speed"]));
    }

    private static bool Wait(Run run) => run.Get<bool>(run["Wait"]);
}
