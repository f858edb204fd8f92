namespace Caterpillar.GH.Components.Simulate;

/// <summary>Shows a toolpath in colors.</summary>
public sealed class ToolpathPreviewComponent() : CaterpillarComponent(
    "Toolpath Preview", "Preview",
        "Shows a toolpath in colors by role, speed, flow, width, layer, order or time, as lines or as beads of true width and height.", Panel.Simulate)
{
    public override Guid ComponentGuid => new("e2b8a4c6-0b7b-4b7c-9a40-6a2d0d7e2f05");

    private protected override bool DrawsItself => true;

    private protected override void Inputs(InputPorts ports)
    {
        ports.Toolpath();
        ports.Choice("Color By", "C", "Value shown by the colors.", PreviewColor.Role);
        ports.Integer("First Layer", "F", "First layer, by its number in the file or from 0. Default: no limit.", optional: true);
        ports.Integer("Last Layer", "L", "Last layer, by its number in the file or from 0. Default: no limit.", optional: true);
        ports.Boolean("Solid", "B", "Show beads of true width and height instead of lines.", false);
        ports.Boolean("Travel", "Tr", "Show travel moves and retractions.", false);
        ports.Setup("Shows the bed and build volume, and sets the print times. Default: no bed, and times of the setup used for planning.");
        ports.Boolean("Seam", "Sm", "Show seams: points at which walls begin.", false);
    }

    private protected override void Outputs(OutputPorts ports)
    {
        ports.Text("Tags", "Ta", "Meaning of each color.", GH_ParamAccess.list);
        ports.Add(new Param_Colour(), "Colors", "C", "Colors of the legend.", GH_ParamAccess.list);
    }

    private protected override void Solve(Run run)
    {
        var goo = run.Get<ToolpathGoo>(0);
        var by = run.Choice<PreviewColor>(1);
        var layers = new ShownLayers(run.MaybeValue<int>(2), run.MaybeValue<int>(3));
        var (beads, travels) = (run.Get<bool>(4), run.Get<bool>(5));
        var units = run.Units;
        var toolpath = goo.Value;
        if (beads && toolpath.Count > ToolpathScene.MostBeads)
        {
            run.Report(GH_RuntimeMessageLevel.Remark,
                "Too many moves for beads: lines are shown. Select fewer layers with Filter Toolpath.");
            beads = false;
        }
        var setup = by == PreviewColor.Time ? SetupPort.Of(run, 6, goo) : null;
        var parts = run.Work("Drawing", [toolpath, units.ToMillimeters], (_, cancel) => new SceneParts(toolpath, units, cancel));
        var values = run.Work("Coloring", [toolpath, by, setup], (progress, cancel) =>
            PreviewColors.ValuesOf(toolpath, parts, by, setup is null ? null : Timeline.Of(toolpath, setup, progress, cancel), cancel));
        var colors = run.Work("Coloring", [values, layers], (_, _) => PreviewColors.Of(values, parts, layers, by));
        var content = new SceneContent(beads, travels, run.Get<bool>(7), run.Maybe<Machines.PrintSetup>(6)?.Printer);
        var scene = run.Work("Drawing", [colors, parts, content], (_, _) => new ToolpathScene(toolpath, parts, layers, colors, content, units));
        run.Show(scene);
        if (scene.Note is { } note) run.Report(GH_RuntimeMessageLevel.Remark, note);
        run.SetList(0, colors.Texts);
        run.SetList(1, colors.Colors.Select(c => new GH_Colour { Value = c }));
    }
}
