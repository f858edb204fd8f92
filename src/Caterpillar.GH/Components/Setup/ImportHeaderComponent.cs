namespace Caterpillar.GH.Components.Setup;

/// <summary>Makes a printer from header and footer files.</summary>
public sealed class ImportHeaderComponent() : CaterpillarComponent(
    "Import Header", "Header", "Creates a printer and a material from files with start and end G-code, as ExtruderTurtle and other "
        + "programs use them.", Panel.Setup, GH_Exposure.tertiary)
{
    private const string Filter = "G-code|*.gcode;*.txt;*.g|All files|*.*";

    public override Guid ComponentGuid => new("3d5b7a90-4c1e-4f6e-8a2d-7b9e0c1f2d07");

    private protected override void Inputs(InputPorts ports)
    {
        ports.File("Header", "H", "File with the start G-code.", Filter);
        ports.File("Footer", "F", "File with the end G-code. Default: none.", Filter, optional: true);
        ports.Profile(new PrinterChoiceParam(), "Base", "B", "Used for values that the files do not contain. Default: generic.");
    }

    private protected override void Outputs(OutputPorts ports)
    {
        ports.Add(new PrinterParam(), "Printer", "P", "Printer.");
        ports.Add(new MaterialParam(), "Material", "M", "Material with the temperatures of the header, in °C.");
        ports.Point("Start", "S", "Nozzle position after the header. Null if the header does not contain it.");
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
