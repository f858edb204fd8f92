using Caterpillar.GH.Components.Design;
using Caterpillar.GH.Components.GCode;
using Caterpillar.GH.Components.Setup;
using Caterpillar.GH.Components.Slice;

namespace Caterpillar.GH.Tests.Examples;

/// <summary>Definitions that slice.</summary>
internal static class SliceDefinitions
{
    public static Sketch PlanarSlice(string name)
    {
        var s = new Sketch(name, "A model from a file, arranged on the bed and sliced into planar layers.",
            "the layer height, the infill in the panel, and Count to print several.");
        var setup = Settings(s, 0.3, null, "infill_density_percent=15");
        var models = Placed(s, "../models/bracket.stl");
        s.Stage("Slice");
        return s.Print(s.With<PlanarSlicerComponent>(setup, ("Geometry", models)), setup);
    }

    public static Sketch Vase(string name)
    {
        var s = new Sketch(name, "A vase as one continuous rising wall. Spiral vase is a setting of the planar slicer.", "the layer height and the line width.");
        var setup = Settings(s, 0.6, 0.8, "spiral_vase=true", "line_width_mm=0.8");
        var models = Placed(s, "../models/vase.stl");
        s.Stage("Slice");
        return s.Print(s.With<PlanarSlicerComponent>(setup, ("Geometry", models)), setup, "Layer");
    }

    public static Sketch CurvedRoof(string name)
    {
        var s = new Sketch(name, "Layers that follow the roof of the model. They are level on the bed, and parallel to the roof from Curved from on.",
            "the two heights: lower ones bend more layers.");
        var setup = Settings(s, 0.6, 0.8, "infill_density_percent=10", "line_width_mm=0.8", "skirt_loops=0");
        var models = Placed(s, "../models/saddle_roof.stl");
        s.Stage("Field");
        var field = s.Component<LayerFieldComponent>(("Surfaces", models), ("Blend From", s.Slider("Level up to", 2, 0, 20)), ("Blend To", s.Slider("Curved from", 18, 1, 40)));
        s.Stage("Slice");
        return s.Print(s.With<CurvedSlicerComponent>(setup, ("Geometry", models), ("Field", field)), setup, "Layer");
    }

    public static Sketch BetweenBoundaries(string name)
    {
        var s = new Sketch(name, "The same number of layers everywhere between the bed and the roof. Layers are thicker in high places, and each bead has its own volume.",
            "Kind of the field. Color shows the flow.");
        var setup = Settings(s, 0.6, 0.8, "infill_density_percent=10", "line_width_mm=0.8", "skirt_loops=0");
        var models = Placed(s, "../models/saddle_roof.stl");
        s.Stage("Field");
        var field = s.Component<LayerFieldComponent>(("Surfaces", models));
        s.Choose(field, "Kind", "Between");
        s.Stage("Slice");
        return s.Print(s.With<CurvedSlicerComponent>(setup, ("Geometry", models), ("Field", field)), setup, "Flow");
    }

    public static Sketch PrintOnTerrain(string name)
    {
        var s = new Sketch(name, "A drawing on a piece of terrain on the bed. The paths follow its surface, travel moves stay above it.",
            "the radius and the spacing of the spiral, and how deep Offset presses it in.");
        var setup = s.Setup();
        var terrain = Placed(s, "../models/terrain.stl");
        s.Stage("Design");
        var spiral = s.Component<SpiralTraceComponent>(("Plane", s.Point("Bed center", 110, 110, 0.2)), ("Radius", s.Slider("Radius", 6, 2, 50, 0)), ("Pitch", s.Slider("Spacing", 3, 0.5, 10)));
        s.Stage("Shape");
        var project = s.With<ProjectPathsComponent>(setup, ("Print Paths", spiral), ("Geometry", terrain), ("Offset", s.Slider("Offset", -0.05, -0.5, 1, 2)),
            ("Partial", s.Toggle("Leave out what misses", true)));
        s.Stage("Plan");
        return s.Finish(s.With<PlanToolpathComponent>(setup, ("Steps", project), ("Obstacles", terrain)));
    }

    private static ArrangeModelsComponent Placed(Sketch s, string file)
    {
        s.Stage("Model");
        return s.Component<ArrangeModelsComponent>(("Geometry", s.Component<ReadModelComponent>(("File", s.Text("File", file, width: 200)))));
    }

    private static Stages.Machine Settings(Sketch s, double layer, double? nozzle, params string[] values)
    {
        s.Stage("Setup");
        object printer = nozzle is { } size ? s.Component<ConstructPrinterComponent>(("Base", s.Choice("Base", "generic", "ender3", "generic", "prusa_mk3s")), ("Nozzle", s.Slider("Nozzle", size, 0.2, 2, 2)))
            : s.Component<PrinterComponent>(("Name", s.Choice("Printer", "generic", "ender3", "generic", "prusa_mk3s")));
        return new Stages.Machine(printer, null, s.Component<ConstructPrintSettingsComponent>(("Layer Height", s.Slider("Layer height", layer, 0.05, 1, 2)),
            ("Overrides", s.Text("Values", string.Join("\n", values), lines: true))));
    }
}
