using Caterpillar.GH.Base;
using Caterpillar.GH.Conversion;
using Caterpillar.GH.Goos;
using Caterpillar.GH.Params;
using Caterpillar.GH.Plugin;

namespace Caterpillar.GH.Components.Setup;

/// <summary>A printer from a profile.</summary>
public sealed class PrinterComponent() : ProfileComponent("Printer", "Printer", "Loads a printer from a profile or a file.")
{
    public override Guid ComponentGuid => new("7974af61-1fa1-4de7-9ff5-cbf83ddab480");

    private protected override void Inputs(InputPorts ports)
    {
        ports.Text("Name", "N", "Name of the printer profile, such as generic, ender3 or prusa_mk3s.", "generic");
        ports.File("File", "F", "File of your own profile (JSON). Replaces Name.", "Printer profile|*.json", optional: true);
    }

    private protected override void Outputs(OutputPorts ports)
    {
        ports.Add(new PrinterParam(), "Printer", "P", "Printer.");
        ports.Curve("Bed", "B", "Outline of the bed.");
        ports.Diagnostics();
    }

    private protected override void Solve(Run run)
    {
        var file = run.Maybe<string>(1);
        var printer = run.Require(Profiles.Library.Printer(string.IsNullOrEmpty(file) ? run.Get<string>(0) : run.PathTo(file!)));
        run.SetAll(new PrinterGoo(printer), RhinoGeometry.ToBed(printer, run.Units));
    }
}
