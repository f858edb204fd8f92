namespace Caterpillar.GH.Components.Setup;

/// <summary>Makes a printer, a material and settings from those of another slicer, or a printer from the start and end code of a print or of files.</summary>
public sealed class ImportProfileComponent() : CaterpillarComponent(
    "Import Profile", "Import", "Creates a printer, a material and settings from those of PrusaSlicer (.ini), OrcaSlicer or Bambu Studio (.json), also in "
        + "their prints and 3MF projects, or a printer from start and end code, as ExtruderTurtle uses them.", Panel.Setup, GH_Exposure.tertiary)
{
    private const string Filter = "Settings and G-code|*.ini;*.json;*.3mf;*.gcode;*.bgcode;*.gco;*.txt;*.g;*.gz|All files|*.*";

    public override Guid ComponentGuid => new("3d5b7a90-4c1e-4f6e-8a2d-7b9e0c1f2d07");

    private protected override void Inputs(InputPorts ports)
    {
        ports.File("File", "F", "Settings of another slicer, G-code of a print, or a file with start code only.", Filter);
        ports.File("Footer", "Fo", "File with the end code. Default: the end of the print in File.", Filter, optional: true);
        ports.Profile(new PrinterChoiceParam(), "Base", "B", "Used for values that the files do not contain. Default: generic.");
        ports.Text("Name", "N", "Name of the printer in a file with several. Default: the first.", optional: true);
    }

    private protected override void Outputs(OutputPorts ports)
    {
        ports.Add(new PrinterParam(), "Printer", "P", "Printer that the file is for.");
        ports.Add(new MaterialParam(), "Material", "M", "Material with the temperatures of the start code, in °C.");
        ports.Point("Start", "S", "Nozzle position after the start code. Null if it is not known.");
        ports.Add(new SettingsParam(), "Settings", "Se", "Print settings, if the file has them.");
        ports.Diagnostics();
    }

    private protected override void Solve(Run run)
    {
        var (header, footer) = (run.Get<string>(0), run.Maybe<string>(1));
        var (before, after) = (run.FileAt(header), string.IsNullOrEmpty(footer) ? null : run.FileAt(footer!));
        var like = run.Maybe<Printer>(2);
        var name = System.IO.Path.GetFileNameWithoutExtension(header);
        var wanted = run.Maybe<string>(3);
        object?[] key = [before.FullName, before.LastWriteTimeUtc, before.Length, after?.FullName, after?.LastWriteTimeUtc, after?.Length, like, wanted];
        var made = run.Require(run.Work("Importing", key, (_, _) => ProfileImport.Read(File.ReadAllBytes(before.FullName),
            after is null ? null : File.ReadAllBytes(after.FullName), string.IsNullOrWhiteSpace(name) ? "imported" : name, like, header, footer ?? "footer",
            string.IsNullOrEmpty(wanted) ? null : wanted)));
        var (printer, usual) = (made.Printers.FirstOrDefault(), like ?? new Printer());
        // Its material and settings have outputs of their own; no folder has them.
        if (made.Materials.Any(m => m.Name == printer?.DefaultMaterial)) printer = printer! with { DefaultMaterial = usual.DefaultMaterial };
        if (made.Settings.Any(s => s.Name == printer?.DefaultSettings)) printer = printer! with { DefaultSettings = usual.DefaultSettings };
        run.SetAll(printer is null ? null : new PrinterGoo { Value = printer }, made.Materials.Count > 0 ? new MaterialGoo { Value = made.Materials[0] } : null,
            made.Start is { } start ? RhinoGeometry.ToPoint(start, run.Units) : null,
            made.Settings.Count > 0 ? new SettingsGoo { Value = made.Settings[0] } : null);
    }
}
