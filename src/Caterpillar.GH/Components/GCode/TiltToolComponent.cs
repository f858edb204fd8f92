namespace Caterpillar.GH.Components.GCode;

/// <summary>Where a tilting tool points.</summary>
public enum TiltAim
{
    LayerNormals,
    Toward,
    Away,
    Formula,
}

/// <summary>Leans the tool of a printer with rotary axes.</summary>
public sealed class TiltToolComponent() : ChosenPortsComponent(
    "Tilt Tool", "Tilt", "Leans the tool of a printer with rotary axes. Where the print head would hit the print, it leans less.", Panel.GCode,
    GH_Exposure.secondary)
{
    public override Guid ComponentGuid => new("c27f4e0b-58d3-4a96-8f1c-3be0d9a57c14");

    private protected override void Inputs(InputPorts ports)
    {
        ports.Add(new ToolpathParam(), "Toolpath", "T", "Toolpath, from Plan Toolpath.");
        ports.Setup("Its printer needs rotary axes, such as five_axis_head. Default: as the toolpath was planned with.");
        ports.Choice("Aim", "A", "Where the tool points. Layer Normals: along the normals of curved layers. Toward: the head leans to curves or points. Away: "
            + "it leans away from them. Formula: formulas give the direction.", TiltAim.LayerNormals);
        ports.For("Aim", [TiltAim.LayerNormals], () => ports.Add(new LayerFieldParam(), "Field", "F", "Field of the layers, from Curved Slicer."));
        ports.For("Aim", [TiltAim.Toward, TiltAim.Away],
            () => ports.Geometry("Geometry", "G", "Curves or points. The nearest one counts.", GH_ParamAccess.list));
        ports.For("Aim", [TiltAim.Formula], () => ports.Text("Expressions", "E",
            "Direction from the tip to the head: formulas of its x, y and z, in x, y and z (mm). Example: 0.3, 0, 1.", access: GH_ParamAccess.list));
        ports.Angle("Max Tilt", "MT", "Maximum lean from vertical, in degrees. Less where the axes allow less.", 90);
    }

    private protected override void Outputs(OutputPorts ports)
    {
        ports.Add(new ToolpathParam(), "Toolpath", "T", "Toolpath with the directions of the tool, for Generate G-code. Arcs become segments.");
        ports.Diagnostics();
    }

    private protected override void Solve(Run run)
    {
        var goo = run.Get<ToolpathGoo>(0);
        var setup = SetupPort.Of(run, 1, goo);
        if (setup.Printer.Kinematics is not { Tilts: true })
            throw new InputProblem($"{setup.Printer.Title} has no axis that tilts its tool. Give rotary_axes of the printer.");
        var (aim, key) = Aim(run);
        var most = run.Within(run["Max Tilt"], 1, 180, "an angle from 1 to 180 degrees");
        var tilted = run.Work("Tilting", [goo.Value, setup, most, key],
            (progress, cancel) => TiltedTool.Apply(goo.Value, setup, aim with { MaxTilt = most }, progress, cancel));
        run.Set(0, new ToolpathGoo(tilted, setup));
    }

    private static (ToolAim Aim, object Key) Aim(Run run)
    {
        var kind = run.Choice<TiltAim>(2);
        switch (kind)
        {
            case TiltAim.LayerNormals:
                var recipe = run.Get<FieldRecipe>(run["Field"]);
                var field = recipe.Made ?? throw new InputProblem("Field depends on the solids. Connect the output Field of Curved Slicer.");
                return (TiltedTool.Along(field), recipe);
            case TiltAim.Formula:
                var texts = run.Some<GH_String>(run["Expressions"]).Select(t => t.Value.Trim()).ToArray();
                if (texts.Length != 3) throw new InputProblem("Formula needs three expressions: the x, y and z of the direction.");
                return (run.Require(ToolAim.Formulas(texts, null, new SourceLocation(Key: "expressions"))), string.Join(";", texts));
            default:
                var curves = run.Some<IGH_GeometricGoo>(run["Geometry"]).Select(g => Place(g, run.Units)).ToArray();
                return (ToolAim.Toward(curves, kind == TiltAim.Away), kind + string.Join(";", curves.Select(c => string.Join(" ", c.Points))));
        }
    }

    private static Polyline Place(IGH_GeometricGoo goo, DocumentUnits units) => Wrapped.Bare(goo.ScriptVariable()) switch
    {
        Rg.Point3d point => new Polyline([RhinoGeometry.ToVec(point, units)]),
        Rg.Curve curve => RhinoCurves.Chords(curve, 0.05, units),
        _ => throw new InputProblem("Geometry must be curves or points."),
    };
}
