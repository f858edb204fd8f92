using Caterpillar.GH.Base;
using Caterpillar.GH.Goos;
using Caterpillar.GH.Params;
using Caterpillar.GH.Plugin;
using Caterpillar.Machines;
using Grasshopper.Kernel;

namespace Caterpillar.GH.Components.Setup;

/// <summary>A material from a profile.</summary>
public sealed class MaterialComponent() : ProfileComponent("Material", "Material", "Loads a material from a profile or a file.")
{
    public override Guid ComponentGuid => new("b38a4d05-4122-429f-8b49-c7313ba87d9d");

    private protected override void Inputs(InputPorts ports)
    {
        ports.Text("Name", "N", "Name of the material profile, such as pla, petg or clay.", "pla");
        ports.File("File", "F", "File of your own profile (JSON). Replaces Name.", "Material profile|*.json", optional: true);
        ports.Overrides("nozzle_temperature_c=215");
    }

    private protected override void Outputs(OutputPorts ports)
    {
        ports.Add(new MaterialParam(), "Material", "M", "Material.");
        ports.Diagnostics();
    }

    private protected override void Solve(Run run)
    {
        var file = run.Maybe<string>(1);
        var material = run.Require(Profiles.Library.Material(string.IsNullOrEmpty(file) ? run.Get<string>(0) : run.PathTo(file!)));
        run.Set(0, new MaterialGoo(run.Require((new PrintSetup() with { Material = material }).With(run.List<string>(2))).Material));
    }
}
