namespace Caterpillar.GH.Components.Slice;

/// <summary>Reads models from a file.</summary>
public sealed class ReadModelComponent() : CaterpillarComponent(
    "Read Model", "Model", "Reads the models of a mesh file, without importing them into Rhino.", Panel.Slice, GH_Exposure.tertiary)
{
    public override Guid ComponentGuid => new("d80b6e35-29f7-4ac1-95be-40c6f1e7a982");

    private protected override void Inputs(InputPorts ports)
    {
        ports.File("File", "F", "File to read: STL, OBJ, PLY or 3MF. May be packed with gzip.",
            "Models (*.stl;*.obj;*.ply;*.3mf;*.gz)|*.stl;*.obj;*.ply;*.3mf;*.gz|All files|*.*");
        ports.Number("Unit", "U", "Length of one unit in mm, if the file does not state its unit.", 1);
    }

    private protected override void Outputs(OutputPorts ports)
    {
        ports.Add(new Param_Mesh(), "Meshes", "M", "Models, at their position in the file.", GH_ParamAccess.list);
        ports.Text("Names", "N", "Names of the models in the file.", GH_ParamAccess.list);
        ports.Diagnostics();
    }

    private protected override void Solve(Run run)
    {
        var file = run.FileAt(run.Get<string>(0));
        var options = new MeshReadOptions { UnitLength = run.Positive(1) };
        var units = run.Units;
        var read = run.Work("Reading", [file.FullName, file.LastWriteTimeUtc, file.Length, options.UnitLength],
            (progress, cancel) => MeshReader.Read(File.ReadAllBytes(file.FullName), file.FullName, options, progress, cancel));
        var models = run.Require(read);
        run.SetList(0, run.Cached([read, units.ToMillimeters], () => models.Select(m => RhinoMesh.FromTriangles(m.Mesh, units)).ToArray()));
        run.SetList(1, models.Select(m => m.Name));
    }
}
