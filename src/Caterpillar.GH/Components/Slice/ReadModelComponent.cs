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
        ports.Setup();
    }

    private protected override void Outputs(OutputPorts ports)
    {
        ports.Add(new Param_Mesh(), "Meshes", "M", "Models, at their position in the file.", GH_ParamAccess.list);
        ports.Text("Names", "N", "Names of the models in the file.", GH_ParamAccess.list);
        ports.Add(new SettingsParam(), "Part Settings", "PS", "Print settings of each model, as a 3MF project of PrusaSlicer, OrcaSlicer or Bambu Studio "
            + "states them; the rest is from Setup.", GH_ParamAccess.list);
        ports.Add(new Param_Mesh(), "Modifiers", "Mo", "Modifiers, support blockers and enforcers of a project, and what is painted in it.",
            GH_ParamAccess.list);
        ports.Add(new SettingsParam(), "Modifier Settings", "MS", "Print settings of each modifier.", GH_ParamAccess.list);
        ports.Diagnostics();
    }

    private protected override void Solve(Run run)
    {
        var file = run.FileAt(run.Get<string>(0));
        var options = new MeshReadOptions { UnitLength = run.Positive(1) };
        var units = run.Units;
        var read = run.Work("Reading", [file.FullName, file.LastWriteTimeUtc, file.Length, options.UnitLength],
            (progress, cancel) => MeshReader.Read(File.ReadAllBytes(file.FullName), file.FullName, options, progress, cancel));
        var meshes = run.Require(read);
        var models = ProjectModels.Models(meshes, run.Require(ProjectModels.Settings(meshes, SetupPort.Of(run, 2))));
        var parts = models.Where(m => m.Settings.ModelType == ModelType.Part).ToArray();
        var modifiers = models.Except(parts).ToArray();
        var shown = run.Cached([read, units.ToMillimeters], () => Array.ConvertAll([.. parts, .. modifiers], m => RhinoMesh.FromTriangles(m.Mesh.Mesh, units)));
        run.SetList(0, shown.Take(parts.Length));
        run.SetList(1, parts.Select(m => m.Mesh.Name));
        run.SetList(2, parts.Select(m => new SettingsGoo { Value = m.Settings }));
        run.SetList(3, shown.Skip(parts.Length));
        run.SetList(4, modifiers.Select(m => new SettingsGoo { Value = m.Settings }));
    }
}
