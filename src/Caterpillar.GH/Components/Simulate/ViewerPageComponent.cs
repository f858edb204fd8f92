using System.Diagnostics;

namespace Caterpillar.GH.Components.Simulate;

/// <summary>Writes a page that shows a toolpath in a browser.</summary>
public sealed class ViewerPageComponent() : CaterpillarComponent(
    "Viewer Page", "View", "Saves a toolpath as a page that shows it in 3D in any browser, without a network.", Panel.Simulate, GH_Exposure.secondary)
{
    private readonly Buttons _save = new(input: 2);
    private readonly Buttons _open = new(input: 4);
    private bool _saves;
    private bool _opens;

    public override Guid ComponentGuid => new("e94c1a75-08d6-4b2e-a3f7-b62d5c80e917");

    /// <summary>Opens a file in the program for it.</summary>
    internal static Action<string> Opens { get; set; } = file => Process.Start(new ProcessStartInfo(file) { UseShellExecute = true })?.Dispose();

    private protected override void Inputs(InputPorts ports)
    {
        ports.Toolpath();
        ports.Target("File", "F", "Page (.html) or script (.js) to write. Relative paths start at the folder of the definition.", "Page|*.html|Script|*.js");
        ports.Boolean("Save", "S", "Saves the page when this changes from false to true. Connect a button.", false);
        ports.Boolean("Overwrite", "O", "Overwrite an existing file.", false);
        ports.Boolean("Open", "Op", "Opens the saved page in the browser when this changes from false to true. Connect a button.", false);
    }

    private protected override void Outputs(OutputPorts ports) => ports.Text("Path", "P", "Path of the page, if it exists.");

    private protected override void Prepare(Run run) => (_saves, _opens) = (_save.IsPressed(run), _open.IsPressed(run));

    private protected override void Solve(Run run)
    {
        var goo = run.Get<ToolpathGoo>(0);
        var name = run.Get<string>(1);
        if (name.Trim().Length == 0) throw new InputProblem("File is missing.") { IsMissing = true };
        var file = run.PathTo(name);
        if (_saves) Save(run, goo, file);
        if (_opens) Opens(File.Exists(file) ? file : throw new InputProblem("There is no page yet. Press Save first."));
        run.Set(0, File.Exists(file) ? file : null);
    }

    private static void Save(Run run, ToolpathGoo goo, string file)
    {
        if (File.Exists(file) && !run.Get<bool>(3)) throw new InputProblem($"{file} already exists. Set Overwrite to true to replace it.");
        var setup = SetupPort.Of(run, -1, goo);
        run.Wait("Saving", (progress, cancel) =>
        {
            var timeline = Timeline.Of(goo.Value, setup, null, cancel);
            var content = new ViewerContent(System.IO.Path.GetFileNameWithoutExtension(file))
            {
                Toolpath = goo.Value, EndOf = timeline.EndOf, Printer = setup.Printer, Shape = setup.Settings.BeadShape, Density = setup.Material.Density,
            };
            ViewerPage.WriteFile(content, file, progress, cancel);
            return content;
        });
    }
}
