namespace Caterpillar.GH.Components.GCode;

/// <summary>Writes G-code, or a toolpath as G-code, to a file when a button is pressed.</summary>
public sealed class SaveGCodeComponent() : CaterpillarComponent(
    "Save G-code", "Save", "Saves a toolpath or G-code to a file when Save becomes true. Toolpaths are checked first, and those that could damage the machine "
        + "are refused. The file is written completely or not at all.", Panel.GCode)
{
    private readonly Buttons _save = new(input: 2);

    // What was saved or refused last, by item.
    private readonly Dictionary<int, Saved> _saved = [];
    private bool _pressed;

    public override Guid ComponentGuid => new("9e6a8f1a-0011-4d61-99a7-075d3a567637");

    private protected override void Inputs(InputPorts ports)
    {
        ports.Add(new Param_GenericObject(), "G-code", "G", "Toolpath from Plan Toolpath, or G-code.");
        ports.Target("File", "F", "File to write. Names that end in .bgcode give binary G-code. Relative paths start at the folder of the "
            + "definition.", "G-code|*.gcode|Binary G-code|*.bgcode");
        ports.Boolean("Save", "S", "Saves the file when this changes from false to true. Connect a button.", false);
        ports.Boolean("Overwrite", "O", "Overwrite an existing file.", false);
    }

    private protected override void Outputs(OutputPorts ports)
    {
        ports.Text("Path", "P", "Path of the file, once this G-code is saved.");
        ports.Diagnostics();
    }

    private protected override void Prepare(Run run) => _pressed = _save.IsPressed(run);

    private protected override void Solve(Run run)
    {
        var source = run.Get<IGH_Goo>(0);
        var code = new GCodeGoo();
        if (source is not ToolpathGoo { Value: not null } && !code.CastFrom(source))
            throw new InputProblem($"G-code: data conversion failed from {source.TypeName} to Toolpath or G-code.");
        var name = run.Get<string>(1);
        if (name.Trim().Length == 0) throw new InputProblem("File is missing.") { IsMissing = true };
        var file = run.PathTo(name);
        object content = (object?)code.Value ?? ((ToolpathGoo)source).Value;
        if (_pressed) _saved[run.Iteration] = Save(run, source as ToolpathGoo, content, file, run.Get<bool>(3));
        var last = _saved.TryGetValue(run.Iteration, out var saved) && ReferenceEquals(saved.Content, content) && saved.File == file ? saved : null;
        run.Report(last?.Diagnostics ?? []);
        var done = last?.Size is not null && File.Exists(file);
        run.Set(0, done ? file : null);
        if (last is not null) run.Summarize(done ? $"{NumberFormatter.Format(last.Size!.Value / 1024)} KB saved" : "refused");
    }

    private static Saved Save(Run run, ToolpathGoo? toolpath, object content, string file, bool overwrite)
    {
        if (File.Exists(file) && !overwrite) throw new InputProblem($"{file} already exists. Set Overwrite to true to replace it.");
        var setup = toolpath is null ? null : WrittenToolpath.SetupOf(run, -1, toolpath);
        return run.Wait("Saving", (progress, cancel) =>
        {
            var written = toolpath is null ? new Result<GCodeDocument>((GCodeDocument)content, [])
                : WrittenToolpath.Write(toolpath, setup!, null, false, new EditOptions(), progress, cancel);
            written.Value?.WriteFile(file, progress, cancel);
            return new Saved(content, file, written.Value?.Length, written.Diagnostics);
        });
    }

    /// <summary>What became of a toolpath or of G-code. Without a size it was refused.</summary>
    private sealed record Saved(object Content, string File, long? Size, IReadOnlyList<Diagnostic> Diagnostics);
}
