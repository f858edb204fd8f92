namespace Caterpillar.GH.Components.Setup;

/// <summary>Print settings from a profile, with some values of their own.</summary>
public sealed class PrintSettingsComponent() : KeyPortsComponent<PrintSettings>(
    "Print Settings", "Settings", "Loads print settings from a profile or a file, and changes their values. Zoom in and press + for more of them.", "standard")
{
    public override Guid ComponentGuid => new("eb1bc290-3166-4963-b83d-d36f484b35cb");

    private protected override IReadOnlyList<UsualKey> Usual =>
    [
        new("Layer Height", "H", "layer_height_mm"),
        new("Line Width", "W", "line_width_mm"),
        new("Print Speed", "V", "print_speed_mm_s"),
        new("Travel Speed", "T", "travel_speed_mm_s"),
        new("Subdivision Distance", "Sd", "subdivision_distance_mm"),
    ];

    private protected override void Inputs(InputPorts ports)
    {
        ports.Profile(new SettingsChoiceParam(), "Profile", "P", "Default: standard.");
        UsualPorts(ports);
    }

    private protected override void Outputs(OutputPorts ports)
    {
        ports.Add(new SettingsParam(), "Settings", "S", "Print settings, for Print Setup.");
        ports.Diagnostics();
    }

    private protected override void Solve(Run run)
        => run.Set(0, new SettingsGoo { Value = With(run, new PrintSetup() with { Settings = Profile(run) }).Settings });
}
