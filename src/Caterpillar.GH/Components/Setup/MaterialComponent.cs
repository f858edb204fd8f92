namespace Caterpillar.GH.Components.Setup;

/// <summary>A material from a profile, with some values of its own.</summary>
public sealed class MaterialComponent() : KeyPortsComponent<Material>(
    "Material", "Material", "Loads a material from a profile or a file, and changes its values. Zoom in and press + for more of them.", "pla")
{
    public override Guid ComponentGuid => new("b38a4d05-4122-429f-8b49-c7313ba87d9d");

    private protected override IReadOnlyList<UsualKey> Usual =>
    [
        new("Nozzle Temperature", "N", "nozzle_temperature_c"),
        new("Bed Temperature", "B", "bed_temperature_c"),
        new("Filament Diameter", "D", "filament_diameter_mm"),
        new("Flow Ratio", "F", "flow_ratio"),
    ];

    private protected override void Inputs(InputPorts ports)
    {
        ports.Profile(new MaterialChoiceParam(), "Profile", "P", "Default: pla.");
        UsualPorts(ports);
    }

    private protected override void Outputs(OutputPorts ports)
    {
        ports.Add(new MaterialParam(), "Material", "M", "Material, for Print Setup.");
        ports.Diagnostics();
    }

    private protected override void Solve(Run run)
        => run.Set(0, new MaterialGoo { Value = With(run, new PrintSetup() with { Material = Profile(run) }).Material });
}
