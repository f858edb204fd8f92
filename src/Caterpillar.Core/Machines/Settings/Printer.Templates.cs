namespace Caterpillar.Machines;

// Lines that go into every file.
public sealed partial record Printer
{
    /// <summary>Start G-code.</summary>
    public ValueList<string> StartGCode { get; init => field = TemplateKeys.StartGCode.Check(value); } = ValueList<string>.Empty;

    /// <summary>End G-code.</summary>
    public ValueList<string> EndGCode { get; init => field = TemplateKeys.EndGCode.Check(value); } = ValueList<string>.Empty;

    /// <summary>G-code before each layer except the first.</summary>
    public ValueList<string> LayerChangeGCode { get; init => field = TemplateKeys.LayerChangeGCode.Check(value); } = ValueList<string>.Empty;

    /// <summary>Macros of the firmware that files may call: NAME=homes heats, NAME=cools, or NAME=harmless.</summary>
    public ValueList<string> Macros { get; init => field = TemplateKeys.Macros.Check(value); } = ValueList<string>.Empty;

    /// <summary>G-code for a tool change; empty = tool number only (T1).</summary>
    public ValueList<string> ToolChangeGCode { get; init => field = TemplateKeys.ToolChangeGCode.Check(value); } = ValueList<string>.Empty;
}

/// <summary>Keys of printers: G-code templates.</summary>
internal static class TemplateKeys
{
    public static readonly KeyTable<Printer> All = new();

    private static readonly LinesFormat Lines = new(PrintTemplate.Error);

    public static readonly ProfileKey<Printer, ValueList<string>> StartGCode
        = All.Of("start_gcode", Lines, p => p.StartGCode, (p, v) => p with { StartGCode = v });
    public static readonly ProfileKey<Printer, ValueList<string>> EndGCode
        = All.Of("end_gcode", Lines, p => p.EndGCode, (p, v) => p with { EndGCode = v });
    public static readonly ProfileKey<Printer, ValueList<string>> LayerChangeGCode
        = All.Of("layer_change_gcode", Lines, p => p.LayerChangeGCode, (p, v) => p with { LayerChangeGCode = v });
    public static readonly ProfileKey<Printer, ValueList<string>> Macros
        = All.Of("macros", new LinesFormat(MacroEffect.Error), p => p.Macros, (p, v) => p with { Macros = v });
    public static readonly ProfileKey<Printer, ValueList<string>> ToolChangeGCode
        = All.Of("tool_change_gcode", Lines, p => p.ToolChangeGCode, (p, v) => p with { ToolChangeGCode = v });
}
