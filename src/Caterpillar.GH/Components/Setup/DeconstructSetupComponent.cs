namespace Caterpillar.GH.Components.Setup;

/// <summary>Takes a setup apart.</summary>
public sealed class DeconstructSetupComponent() : CaterpillarComponent(
    "Deconstruct Setup", "DeSetup", "Deconstructs a print setup into its printer, material and print settings, with all values by their keys.", Panel.Setup,
    GH_Exposure.tertiary)
{
    public override Guid ComponentGuid => new("d6f20b95-7e41-4c8a-9a3f-5b1d8c0e2f31");

    private protected override void Inputs(InputPorts ports) => ports.Add(new SetupParam(), "Setup", "Se", "Print setup, or the name of a printer profile.");

    private protected override void Outputs(OutputPorts ports)
    {
        ports.Add(new PrinterParam(), "Printer", "P", "Printer of the setup.");
        ports.Add(new MaterialParam(), "Material", "M", "Material of each tool.", GH_ParamAccess.list);
        ports.Add(new SettingsParam(), "Settings", "S", "Print settings of the setup.");
        ports.Add(new Param_Mesh { Hidden = true }, "Printed On", "O", "Objects on the bed to print on, as one mesh. Null if none.");
        ports.Curve("Bed", "B", "Outline of the bed.");
        ports.Text("Keys", "K", "Keys of settings, printer and material. They include the unit.", GH_ParamAccess.list);
        ports.Text("Values", "V", "Value of each key.", GH_ParamAccess.list);
    }

    private protected override void Solve(Run run)
    {
        var setup = run.Get<PrintSetup>(0);
        var units = run.Units;
        run.Set(0, new PrinterGoo { Value = setup.Printer });
        run.SetList(1, setup.ToolMaterials.Prepend(setup.Material).Select(m => new MaterialGoo { Value = m }));
        run.Set(2, new SettingsGoo { Value = setup.Settings });
        run.Set(3, setup.PrintedOn is { } mesh ? RhinoMesh.FromTriangles(mesh, units) : null);
        run.Set(4, RhinoGeometry.ToBed(setup.Printer, units));
        var values = setup.Values();
        run.SetList(5, values.Select(v => v.Key));
        run.SetList(6, values.Select(v => v.Value));
    }
}
