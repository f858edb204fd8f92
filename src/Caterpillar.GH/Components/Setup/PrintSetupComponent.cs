namespace Caterpillar.GH.Components.Setup;

/// <summary>Printer, material, settings and what is printed on, as one value for all components.</summary>
public sealed class PrintSetupComponent() : ProfileComponent(
    "Print Setup", "Setup", "Combines printer, material and print settings, and what is printed on, for all components that need any of them. Choose "
        + "profiles in the menus of the inputs.", GH_Exposure.primary)
{
    // Deviation of the facets of a curved object, mm.
    private const double Tolerance = 0.05;

    public override Guid ComponentGuid => new("4a8c1e72-9b3d-4f06-8d57-2c0e6f9b1a30");

    private protected override void Inputs(InputPorts ports)
    {
        ports.Profile(new PrinterChoiceParam(), "Printer", "P", "Default: generic.");
        ports.Profile(new MaterialChoiceParam(), "Material", "M", "A list is for the tools in their order. Default: as the printer names it.",
            GH_ParamAccess.list);
        ports.Profile(new SettingsChoiceParam(), "Settings", "S", "Default: as the printer names them.");
        ports.Geometry("Printed On", "O", "Objects on the bed to print on. Travel moves stay above them, checks find collisions with them, and curved layers "
            + "begin on them.", GH_ParamAccess.list, optional: true);
    }

    private protected override void Outputs(OutputPorts ports)
    {
        ports.Add(new SetupParam(), "Setup", "Se", "Print setup, for slicers, Turtle, Plan Toolpath, Check and Generate G-code.");
        ports.Diagnostics();
    }

    private protected override void Solve(Run run)
    {
        var materials = run.List<Material>(1);
        var setup = run.Require(Profiles.Setup(run.Maybe<Printer>(0), materials.FirstOrDefault(), run.Maybe<PrintSettings>(2), materials.Skip(1)));
        object[] meshes = Array.ConvertAll(run.Models(3, Tolerance), m => (object)m.Triangles);
        // The same mesh for the same objects: what follows is not computed again.
        var mesh = meshes.Length == 0 ? null : run.Work("Joining", meshes, (_, _) => TriMesh.Merge(meshes.Cast<TriMesh>()));
        run.Set(0, new SetupGoo { Value = setup with { PrintedOn = mesh } });
        run.Summarize(setup.Printer.Title);
    }
}
