using Caterpillar.GCode;
using Caterpillar.GH.Base;
using Caterpillar.GH.Params;

namespace Caterpillar.GH.Components.GCode;

/// <summary>Writes G-code to a file when a button is pressed.</summary>
public sealed class SaveGCodeComponent() : CaterpillarComponent(
    "Save G-code", "Save", "Saves G-code to a file when Save becomes true. The file is written completely or not at all.", Panel.GCode)
{
    private readonly Buttons _save = new(input: 2);

    // What was written last, by item.
    private readonly Dictionary<int, (GCodeDocument Document, string File)> _written = [];
    private bool _pressed;

    public override Guid ComponentGuid => new("9e6a8f1a-0011-4d61-99a7-075d3a567637");

    private protected override void Inputs(InputPorts ports)
    {
        ports.Add(new GCodeParam(), "G-code", "G", "G-code to save.");
        ports.Target("File", "F", "File to write. Names that end in .bgcode give binary G-code. Relative paths start at the folder of the "
            + "definition.", "G-code|*.gcode|Binary G-code|*.bgcode");
        ports.Boolean("Save", "S", "Saves the file when this changes from false to true. Connect a button.", false);
        ports.Boolean("Overwrite", "O", "Overwrite an existing file.", false);
    }

    private protected override void Outputs(OutputPorts ports) => ports.Text("Path", "P", "Path of the file, once this G-code is saved.");

    private protected override void Prepare(Run run) => _pressed = _save.IsPressed(run);

    private protected override void Solve(Run run)
    {
        var document = run.Get<GCodeDocument>(0);
        var name = run.Get<string>(1);
        if (name.Trim().Length == 0) throw new InputProblem("File is missing.") { IsMissing = true };
        var file = run.PathTo(name);
        if (_pressed) Write(run, document, file, run.Get<bool>(3));
        var done = _written.TryGetValue(run.Iteration, out var last) && ReferenceEquals(last.Document, document) && last.File == file && File.Exists(file);
        run.Set(0, done ? file : null);
        if (done) run.Summarize($"{NumberFormatter.Format(document.Length / 1024)} KB saved");
    }

    private void Write(Run run, GCodeDocument document, string file, bool overwrite)
    {
        if (File.Exists(file) && !overwrite) throw new InputProblem($"{file} already exists. Set Overwrite to true to replace it.");
        run.Wait("Saving", (progress, cancel) =>
        {
            document.WriteFile(file, progress, cancel);
            return file;
        });
        _written[run.Iteration] = (document, file);
    }
}
