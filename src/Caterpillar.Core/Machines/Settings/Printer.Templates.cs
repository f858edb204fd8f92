namespace Caterpillar.Machines;

// Lines that go into every file.
public sealed partial record Printer
{
    /// <summary>Start G-code.</summary>
    public ValueList<string> StartGCode { get; init => field = Keys.Check(value); } = ValueList<string>.Empty;

    /// <summary>End G-code.</summary>
    public ValueList<string> EndGCode { get; init => field = Keys.Check(value); } = ValueList<string>.Empty;

    /// <summary>G-code before each layer except the first.</summary>
    public ValueList<string> LayerChangeGCode { get; init => field = Keys.Check(value); } = ValueList<string>.Empty;

    /// <summary>Macros of the firmware that files may call: NAME=homes heats, NAME=cools, or NAME=harmless.</summary>
    public ValueList<string> Macros { get; init => field = Keys.Check(value); } = ValueList<string>.Empty;

    /// <summary>G-code for a tool change; empty = tool number only (T1).</summary>
    public ValueList<string> ToolChangeGCode { get; init => field = Keys.Check(value); } = ValueList<string>.Empty;
}
