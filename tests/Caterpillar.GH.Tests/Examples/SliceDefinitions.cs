using Caterpillar.GH.Components.Design;
using Caterpillar.GH.Components.GCode;
using Caterpillar.GH.Components.Path;
using Caterpillar.GH.Components.Setup;
using Caterpillar.GH.Components.Simulate;
using Caterpillar.GH.Components.Slice;

namespace Caterpillar.GH.Tests.Examples;

/// <summary>Definitions that slice.</summary>
internal static class SliceDefinitions
{
    public static Sketch FirstPrint(string name)
    {
        var s = new Sketch(name, "Your first print: Print Setup, Planar Slicer, Plan Toolpath, Save G-code. The model is inside this file.",
            "another printer, or your own model: right-click Model and set a mesh. Drag Position to watch the print, then press Save.");
        var setup = s.Setup();
        s.Stage("Model");
        var model = s.Mesh("Model", Solids.Tower(110, 110, 6, (12, 0, 0), (16, 6, 20), (11, 12, 50)));
        s.Stage("Slice");
        var slices = s.With<PlanarSlicerComponent>(setup, ("Geometry", model));
        s.Stage("Plan");
        var plan = s.Component<PlanToolpathComponent>(("Steps", slices));
        s.Stage("Look");
        s.Component<ToolpathPreviewComponent>(("Toolpath", plan), ("Color By", new Pick("Role")));
        var simulate = s.Component<SimulateComponent>(("Toolpath", plan), ("Position", s.Slider("Position", 0.5, 0, 1, 3)));
        s.Show("At this moment", simulate, "State", 4, 270);
        return s.Save(plan);
    }

    public static Sketch PlanarSlice(string name)
    {
        var s = new Sketch(name, "A model that stands askew is laid flat, arranged on the bed and sliced. Wait For Results makes Grasshopper wait for "
            + "long work.",
            "the layer height, the infill, and Count to print several.");
        var setup = Settings(s, 0.3, null, Infill(s, 15));
        s.Stage("Model");
        var flat = s.Component<LayFlatComponent>(("Geometry", s.Mesh("Model", Solids.Askew(100, 100, 30, 18, 12))));
        var models = s.With<ArrangeModelsComponent>(setup, ("Geometry", flat), ("Count", s.Slider("Count", 1, 1, 9, 0)));
        s.Stage("Slice");
        var slices = s.With<PlanarSlicerComponent>(setup, ("Geometry", models));
        s.Component<WaitForResultsComponent>();
        return s.Print(slices);
    }

    public static Sketch Vase(string name)
    {
        var s = new Sketch(name, "A vase as one continuous rising wall. Spiral vase is a setting of the planar slicer.", "the layer height and the nozzle.");
        var setup = Settings(s, 0.6, 0.8, ("Line Width", s.Stage("Setup").Slider("Line width", 0.8, 0.2, 2, 2)), ("spiral_vase", s.Toggle("Spiral vase",
            true)));
        var models = Placed(s, setup, "../models/vase.stl");
        s.Stage("Slice");
        return s.Print(s.With<PlanarSlicerComponent>(setup, ("Geometry", models)), "Layer");
    }

    public static Sketch Modifiers(string name)
    {
        var s = new Sketch(name, "Settings that hold in one place only: inside the box, which is not printed, the infill is dense.",
            "both infills, or move the box in Rhino: model and box are inside this file.");
        var setup = Settings(s, 0.4, null, Infill(s, 10));
        s.Stage("Model");
        var model = s.Mesh("Model", Solids.Box(90, 90, 0, 40, 30, 6));
        var place = s.Mesh("Dense here", Solids.Box(100, 85, 0, 15, 40, 6));
        var dense = s.Component<PrintSettingsComponent>(("infill_density_percent", s.Slider("Infill inside, %", 60, 0, 100, 0)));
        s.Stage("Slice");
        return s.Print(s.With<PlanarSlicerComponent>(setup, ("Geometry", model), ("Modifiers", place), ("Modifier Settings", dense)));
    }

    public static Sketch InfillCurves(string name)
    {
        var s = new Sketch(name, "Your own infill: the curve is printed inside the walls of every layer. Model and curve are inside this file.",
            "another curve: right-click Infill and set one or several.");
        var setup = Settings(s, 0.4, null, ("wall_count", s.Stage("Setup").Slider("Walls", 2, 1, 6, 0)), ("top_layers", s.Slider("Top layers", 0, 0, 8, 0)),
            ("bottom_layers", s.Slider("Bottom layers", 0, 0, 8, 0)));
        s.Stage("Model");
        var model = s.Mesh("Model", Solids.Tower(110, 110, 12, (18, 0, 0), (18, 5, 0)));
        var curve = s.Curve("Infill", Solids.Zigzag(90, 90, 40, 40, 14));
        s.Stage("Slice");
        return s.Print(s.With<PlanarSlicerComponent>(setup, ("Geometry", model), ("Infill Curves", curve)));
    }

    public static Sketch CurvedRoof(string name)
    {
        var s = new Sketch(name, "Layers that follow the roof of the model. They are level on the bed, and parallel to the roof from Curved from on.",
            "the two heights: lower ones bend more layers. The speed is one that the Z axis reaches.");
        var speed = s.Stage("Setup").Slider("Print speed", 25, 5, 200, 0);
        var setup = Settings(s, 0.6, 0.8, ("Line Width", s.Stage("Setup").Slider("Line width", 0.8, 0.2, 2, 2)), Infill(s, 10),
            ("Print Speed", speed), ("outer_wall_speed_mm_s", speed), ("infill_bridge_speed_mm_s", speed));
        var models = Placed(s, setup, "../models/saddle_roof.stl");
        s.Stage("Field");
        var field = s.Component<LayerFieldComponent>(("Surfaces", models), ("Blend From", s.Slider("Level up to", 2, 0, 20)),
            ("Blend To", s.Slider("Curved from", 18, 1, 40)));
        s.Stage("Slice");
        return s.Print(s.With<CurvedSlicerComponent>(setup, ("Geometry", models), ("Field", field)), "Layer");
    }

    public static Sketch BetweenBoundaries(string name)
    {
        var s = new Sketch(name, "The same number of layers everywhere between the bed and the roof. Layers are thicker in high places, and each "
            + "bead has its own "
            + "volume.", "Kind of the field. Color shows the flow.");
        var speed = s.Stage("Setup").Slider("Print speed", 25, 5, 200, 0);
        var setup = Settings(s, 0.6, 0.8, ("Line Width", s.Stage("Setup").Slider("Line width", 0.8, 0.2, 2, 2)), Infill(s, 10),
            ("Print Speed", speed), ("outer_wall_speed_mm_s", speed), ("infill_bridge_speed_mm_s", speed));
        var models = Placed(s, setup, "../models/saddle_roof.stl");
        s.Stage("Field");
        var field = s.Component<LayerFieldComponent>(("Kind", new Pick("Between")), ("Surfaces", models));
        s.Stage("Slice");
        return s.Print(s.With<CurvedSlicerComponent>(setup, ("Geometry", models), ("Field", field)), "Flow");
    }

    public static Sketch WaveLayers(string name)
    {
        var s = new Sketch(name, "Layers parallel to a sheet drawn in Rhino. They begin level on the bed and take its shape. Block and sheet are "
            + "inside this file.",
            "another sheet: right-click it and set a mesh or a surface.");
        var setup = Settings(s, 0.3, null, Infill(s, 10));
        s.Stage("Model");
        var model = s.Mesh("Block", Solids.Box(95, 95, 0, 30, 30, 8));
        var sheet = s.Mesh("Sheet", Solids.Sheet(110, 110, 60, 12, (u, v) => 10 - 2 * u * u - 2 * v * v));
        s.Stage("Field");
        var field = s.Component<LayerFieldComponent>(("Surfaces", sheet), ("Blend From", s.Slider("Level up to", 1, 0, 20)),
            ("Blend To", s.Slider("Curved from", 7, 1, 40)));
        s.Stage("Slice");
        return s.Print(s.With<CurvedSlicerComponent>(setup, ("Geometry", model), ("Field", field)), "Layer");
    }

    public static Sketch SlantedLayers(string name)
    {
        var s = new Sketch(name, "Layers parallel to a slanted surface, in a block. Both were drawn in Rhino as Breps and are inside this file.",
            "your own: right-click Block and Surface and set a Brep or a surface.");
        var setup = Settings(s, 0.3, null, Infill(s, 10));
        s.Stage("Model");
        var block = s.Brep("Block", Solids.Brep("block"));
        var surface = s.Brep("Surface", Solids.Brep("sheet"));
        s.Stage("Field");
        var field = s.Component<LayerFieldComponent>(("Surfaces", surface), ("Blend From", s.Slider("Level up to", 1, 0, 20)),
            ("Blend To", s.Slider("Slanted from", 7, 1, 40)));
        s.Stage("Slice");
        return s.Print(s.With<CurvedSlicerComponent>(setup, ("Geometry", block), ("Field", field)), "Layer");
    }

    public static Sketch TiltedTool(string name)
    {
        var s = new Sketch(name, "Layers that follow a sheet, and a tool that leans along their normals. The printer has two rotary axes in its head.",
            "the maximum tilt, and Aim: toward or away from a point or a curve.");
        s.Stage("Setup");
        var speed = s.Slider("Print speed", 25, 5, 200, 0);
        var settings = s.Component<PrintSettingsComponent>(("Layer Height", s.Slider("Layer height", 0.4, 0.05, 1, 2)), Infill(s, 30),
            ("Print Speed", speed), ("outer_wall_speed_mm_s", speed), ("infill_bridge_speed_mm_s", speed));
        var setup = s.Component<PrintSetupComponent>(("Printer", s.Text("Printer", "five_axis_head", width: 130)), ("Settings", settings));
        s.Stage("Model");
        var model = s.Mesh("Block", Solids.Box(100, 100, 0, 14, 14, 5));
        var sheet = s.Mesh("Sheet", Solids.Sheet(107, 107, 40, 12, (u, v) => 7 - 5 * u * u - 5 * v * v));
        s.Stage("Field");
        var field = s.Component<LayerFieldComponent>(("Surfaces", sheet), ("Blend From", s.Slider("Level up to", 0.6, 0, 20)),
            ("Blend To", s.Slider("Curved from", 4, 1, 40)));
        s.Stage("Slice");
        var most = s.Slider("Max tilt", 30, 1, 90, 0);
        var slices = s.With<CurvedSlicerComponent>(setup, ("Geometry", model), ("Field", field), ("Max Tilt", most));
        s.Stage("Plan");
        var plan = s.Component<PlanToolpathComponent>(("Steps", slices));
        return s.Finish(s.Component<TiltToolComponent>(("Toolpath", plan), ("Field", (slices, "Field")), ("Max Tilt", most)), "Layer");
    }

    public static Sketch PrintOnTerrain(string name)
    {
        var s = new Sketch(name, "A drawing on a piece of terrain on the bed. The paths follow its surface, travel moves stay above it.",
            "the radius and the spacing of the spiral, and how deep Offset presses it in.");
        s.Stage("Model");
        var terrain = s.Component<ArrangeModelsComponent>(("Geometry", s.Component<ReadModelComponent>(("File", s.Text("File", "../models/terrain.stl",
            width: 180)))));
        s.Stage("Setup");
        var slow = s.Component<PrintSettingsComponent>(("Print Speed", s.Slider("Print speed", 20, 5, 200, 0)));
        var setup = s.Setup("generic", ("Settings", slow), ("Printed On", terrain));
        s.Stage("Design");
        var spiral = s.With<RoundTraceComponent>(setup, ("Kind", new Pick("Spiral")), ("Plane", s.Point("Bed center", 110, 110, 0.2)), ("Radius",
            s.Slider("Radius", 6, 2, 50, 0)),
            ("Pitch", s.Slider("Spacing", 3, 0.5, 10)));
        s.Stage("Shape");
        return s.Print(s.With<ProjectPathsComponent>(setup, ("Print Paths", spiral), ("Offset", s.Slider("Offset", -0.05, -0.5, 1, 2)),
            ("Partial", s.Toggle("Partial", true))));
    }

    public static Sketch DrawOnDome(string name)
    {
        var s = new Sketch(name, "A curve drawn flat in Rhino, printed on a dome that stands on the bed. Dome and curve are inside this file.",
            "another curve, or a scan of a real object in the place of the dome.");
        s.Stage("Model");
        var dome = s.Mesh("Dome", Solids.Sheet(110, 110, 80, 24, (u, v) => 14 - 6 * (u * u + v * v)));
        var setup = s.Setup("generic", ("Printed On", dome));
        s.Stage("Design");
        var path = s.With<ConstructPrintPathComponent>(setup, ("Curve", s.Curve("Curve", Solids.Rosette(110, 110, 24, 8, 7, 0.2))));
        s.Stage("Shape");
        return s.Print(s.With<ProjectPathsComponent>(setup, ("Print Paths", path), ("Offset", s.Slider("Offset", 0, -0.5, 1, 2))));
    }

    private static ArrangeModelsComponent Placed(Sketch s, PrintSetupComponent setup, string file)
    {
        s.Stage("Model");
        return s.With<ArrangeModelsComponent>(setup, ("Geometry", s.Component<ReadModelComponent>(("File", s.Text("File", file, width: 200)))));
    }

    // The layer height, a nozzle or the printer of the profile, and any other keys with their values.
    private static PrintSetupComponent Settings(Sketch s, double layer, double? nozzle, params (string Key, object Source)[] keys)
    {
        s.Stage("Setup");
        var settings = s.Component<PrintSettingsComponent>([("Layer Height", s.Slider("Layer height", layer, 0.05, 1, 2)), .. keys]);
        if (nozzle is not { } size) return s.Setup("generic", ("Settings", settings));
        var printer = s.Component<PrinterComponent>(("Nozzle Diameter", s.Slider("Nozzle", size, 0.2, 2, 2)));
        return s.Component<PrintSetupComponent>(("Printer", printer), ("Settings", settings));
    }

    private static (string Key, object Source) Infill(Sketch s, double percent) => ("infill_density_percent", s.Stage("Setup").Slider("Infill, %", percent,
        0, 100, 0));
}
