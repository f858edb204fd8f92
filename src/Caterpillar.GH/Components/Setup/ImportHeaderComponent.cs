using Caterpillar.GH.Base;
using Caterpillar.GH.Conversion;
using Caterpillar.GH.Goos;
using Caterpillar.GH.Params;
using Caterpillar.Machines;
using Grasshopper.Kernel;

namespace Caterpillar.GH.Components.Setup;

/// <summary>Makes a printer from header and footer files.</summary>
public sealed class ImportHeaderComponent() : CaterpillarComponent(
    "Import Header", "Header", "Makes a printer and a material from the G-code before and after a print, as ExtruderTurtle and other programs keep it.",
        Panel.Setup, GH_Exposure.secondary)
{
    private const string Filter = "G-code|*.gcode;*.txt;*.g|All files|*.*";

    public override Guid ComponentGuid => new("3d5b7a90-4c1e-4f6e-8a2d-7b9e0c1f2d07");

    private protected override void Inputs(InputPorts ports)
    {
        ports.File("Header", "H", "File with the lines before the print.", Filter);
        ports.File("Footer", "F", "File with the lines after the print; none by default.", Filter, optional: true);
        ports.Add(new PrinterParam(), "Base", "B", "A similar printer for what the files do not state, or the name of its profile; the generic one by default.",
            optional: true);
    }

    private protected override void Outputs(OutputPorts ports)
    {
        ports.Add(new PrinterParam(), "Printer", "P", "The printer.");
        ports.Add(new MaterialParam(), "Material", "M", "A material with the temperatures of the header, in °C.");
        ports.Point("Start", "S", "Where the header leaves the nozzle, in document units; null if it does not say.");
        ports.Diagnostics();
    }

    private protected override void Solve(Run run)
    {
        var header = run.Get<string>(0);
        var footer = run.Maybe<string>(1);
        var name = System.IO.Path.GetFileNameWithoutExtension(header);
        var before = File.ReadAllText(run.FileAt(header).FullName);
        var after = string.IsNullOrEmpty(footer) ? "" : File.ReadAllText(run.FileAt(footer!).FullName);
        var imported = HeaderImport.Read(before, after, string.IsNullOrWhiteSpace(name) ? "imported" : name, run.Maybe<Printer>(2), header,
            footer ?? "footer");
        var made = run.Require(imported);
        run.SetAll(new PrinterGoo(made.Printer), new MaterialGoo(made.Material), made.Start is { } start ? RhinoGeometry.ToPoint(start, run.Units) : null);
    }
}
