namespace Caterpillar.Machines;

// Lines that go into every file.
public sealed partial record Printer
{
    /// <summary>Lines before the print.</summary>
    public ValueList<string> StartTemplate { get; init => field = TemplateKeys.StartTemplate.Check(value); } = ValueList<string>.Empty;

    /// <summary>Lines after the print.</summary>
    public ValueList<string> EndTemplate { get; init => field = TemplateKeys.EndTemplate.Check(value); } = ValueList<string>.Empty;

    /// <summary>Lines before each layer except the first.</summary>
    public ValueList<string> LayerTemplate { get; init => field = TemplateKeys.LayerTemplate.Check(value); } = ValueList<string>.Empty;

    /// <summary>Lines for a tool change; without them only the tool number (T1).</summary>
    public ValueList<string> ToolChangeTemplate { get; init => field = TemplateKeys.ToolChangeTemplate.Check(value); } = ValueList<string>.Empty;
}

/// <summary>Keys of printers: lines that go into every file.</summary>
internal static class TemplateKeys
{
    public static readonly KeyTable<Printer> All = new();

    private static readonly LinesFormat Lines = new(PrintTemplate.Problem);

    public static readonly ProfileKey<Printer, ValueList<string>> StartTemplate
        = All.Of("start_template", Lines, p => p.StartTemplate, (p, v) => p with { StartTemplate = v });
    public static readonly ProfileKey<Printer, ValueList<string>> EndTemplate
        = All.Of("end_template", Lines, p => p.EndTemplate, (p, v) => p with { EndTemplate = v });
    public static readonly ProfileKey<Printer, ValueList<string>> LayerTemplate
        = All.Of("layer_template", Lines, p => p.LayerTemplate, (p, v) => p with { LayerTemplate = v });
    public static readonly ProfileKey<Printer, ValueList<string>> ToolChangeTemplate
        = All.Of("tool_change_template", Lines, p => p.ToolChangeTemplate, (p, v) => p with { ToolChangeTemplate = v });
}
