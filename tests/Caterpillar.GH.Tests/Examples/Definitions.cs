using System;
using System.Collections.Generic;
using System.Linq;
using Caterpillar.GH.Components.Design;
using Caterpillar.GH.Components.GCode;
using Caterpillar.GH.Components.Path;
using Caterpillar.GH.Components.Setup;
using Caterpillar.GH.Components.Simulate;
using Caterpillar.GH.Components.Slice;
using Grasshopper.Kernel;

namespace Caterpillar.GH.Tests.Examples;

/// <summary>The example definitions of examples/gh, made from code.</summary>
internal static class Definitions
{
    private const string ToBed = "x + 110";

    public static IReadOnlyDictionary<string, Func<string, GH_Document>> All { get; } =
        new SortedDictionary<string, Func<string, GH_Document>>(StringComparer.Ordinal)
    {
        ["bake"] = Bake,
        ["check"] = Check,
        ["custom_printer"] = CustomPrinter,
        ["cup_with_skirt"] = CupWithSkirt,
        ["decode_and_remix"] = DecodeAndRemix,
        ["gap_bead"] = GapBead,
        ["helix_to_sphere"] = HelixToSphere,
        ["l_system_tree"] = Tree,
        ["modulated_ring"] = ModulatedRing,
        ["simulate"] = Simulate,
        ["turtle_commands"] = TurtleCommands,
        ["turtle_star"] = TurtleStar,
        ["planar_slice"] = PlanarSlice,
        ["vase"] = Vase,
        ["curved_roof"] = CurvedRoof,
        ["between_boundaries"] = BetweenBoundaries,
        ["print_on_terrain"] = PrintOnTerrain,
        ["globe_from_image"] = GlobeFromImage,
        ["user_curves"] = UserCurves,
        ["check_and_repair"] = CheckAndRepair,
    };

    private static GH_Document TurtleStar(string name)
    {
        var s = new Sketch(name, "A star drawn by a turtle. The script is in the panel. Change the number of points to change the G-code.");
        var script = s.Text(0, "Script", "param points = 7\njump 110 110 0.2\nbead 0.5 0.2\nspeed 30\nrepeat points [ forward 40; left 180 - 180 / points ]\n");
        var points = s.Text(0, "Points", "points=9", lines: true);
        var program = s.Component<TurtleProgramComponent>(1, ("Script", script), ("Variables", points));
        var turtle = s.Component<TurtleComponent>(2, ("Program", program));
        s.Component<TurtlePreviewComponent>(3, ("Steps", (turtle, "Steps")), ("Position", s.Slider(2, "Position", 0.75, 0, 1)));
        return Print(s, 3, (turtle, "Steps"));
    }

    private static GH_Document TurtleCommands(string name)
    {
        var s = new Sketch(name, "A turtle program from components instead of a script: commands repeated to a square.");
        var forward = s.Component<TurtleMoveComponent>(1, ("Distance", s.Slider(0, "Side", 30, 5, 80, 0)));
        var turn = s.Component<TurtleRotateComponent>(1, ("Yaw", s.Slider(0, "Yaw", 90, 0, 180, 0)));
        var bead = s.Component<TurtleExtrusionComponent>(1, ("Kind", s.Text(0, "Kind", "Width And Height")), ("Value", s.Slider(0, "Width", 0.5, 0.2, 2)),
            ("Height", s.Slider(0, "Height", 0.2, 0.1, 1)), ("Speed", s.Slider(0, "Speed", 25, 1, 100, 0)));
        var square = s.Component<TurtleRepeatComponent>(2, ("Commands", forward), ("Count", s.Slider(1, "Count", 4, 1, 12, 0)));
        square.Params.Input[0].AddSource(turn.Params.Output[0]);
        var program = s.Component<TurtleProgramComponent>(3, ("Script", s.Text(2, "Start", "jump 90 90 0.2")), ("Commands", bead));
        program.Params.Input[1].AddSource(square.Params.Output[0]);
        var turtle = s.Component<TurtleComponent>(4, ("Program", program));
        return Print(s, 5, (turtle, "Steps"));
    }

    private static GH_Document Tree(string name)
    {
        var s = new Sketch(name, "A branching tree as an L-system. F draws, + and - turn, [ and ] branch and return above the print.");
        var system = s.Component<LSystemComponent>(1, ("Axiom", s.Text(0, "Axiom", "F")), ("Rules", s.Text(0, "Rules", "F -> F[+F]F[-F]F", lines: true)),
            ("Generations", s.Slider(0, "Generations", 3, 0, 5, 0)), ("Angle", s.Slider(0, "Angle", 25.7, 0, 90, 1)),
                ("Step", s.Slider(0, "Step", 2, 0.5, 10, 1)));
        var turtle = s.Component<TurtleComponent>(2, ("Program", system));
        var moved = s.Component<DeformComponent>(3, ("Print Paths", turtle), ("X", s.Text(2, "X", "x + 60")), ("Y", s.Text(2, "Y", "y + 110")),
            ("Z", s.Text(2, "Z", "z + 0.2")));
        return Print(s, 4, moved);
    }

    private static GH_Document HelixToSphere(string name)
    {
        var s = new Sketch(name, "A helix becomes a barrel: the radius grows with the height and shrinks again. Shapes without slicing, after Kanada.");
        var helix = s.Component<RisingTraceComponent>(1, ("Radius", s.Slider(0, "Radius", 15, 5, 50, 0)), ("Height", s.Slider(0, "Height", 4, 1, 40, 1)),
            ("Pitch", s.Slider(0, "Pitch", 0.4, 0.1, 2)), ("Segments Per Turn", s.Slider(0, "Segments", 36, 12, 144, 0)));
        var round = s.Component<DeformComponent>(2, ("Print Paths", helix), ("System", s.Text(1, "System", "Cylindrical")),
            ("R", s.Text(1, "New radius", "r + 0.5 * z * (4.2 - z)")));
        return Print(s, 4, Moved(s, 3, round));
    }

    private static GH_Document CupWithSkirt(string name)
    {
        var s = new Sketch(name, "A cup: first a skirt, then a spiral floor, then a widening wall. Steps from several sources are printed in order.");
        var skirt = s.Component<RoundTraceComponent>(1, ("Kind", s.Text(0, "Kind of skirt", "Skirt")),
            ("Radius", s.Slider(0, "Skirt", 22, 10, 60, 0)), ("Loop Count", s.Slider(0, "Loops", 2, 1, 10, 0)));
        var floor = s.Component<RoundTraceComponent>(1, ("Kind", s.Text(0, "Kind of floor", "Spiral")),
            ("Radius", s.Slider(0, "Floor", 15, 5, 50, 0)), ("Pitch", s.Slider(0, "Pitch", 0.5, 0.2, 2)));
        var wall = s.Component<RisingTraceComponent>(1, ("Kind", s.Text(0, "Kind of wall", "Cone")),
            ("Bottom Radius", s.Slider(0, "Bottom", 15, 5, 50, 0)), ("Top Radius", s.Slider(0, "Top", 18, 5, 50, 0)),
            ("Height", s.Slider(0, "Height", 2, 1, 40, 1)), ("Pitch", s.Slider(0, "Rise", 0.25, 0.1, 1)));
        var moved = Moved(s, 2, skirt);
        moved.Params.Input[0].AddSource(floor.Params.Output[0]);
        moved.Params.Input[0].AddSource(wall.Params.Output[0]);
        return Print(s, 3, moved);
    }

    private static GH_Document GapBead(string name)
    {
        var s = new Sketch(name, "Waves on a flat ring. Each extrusion gets the material that fills the gap below it.");
        var ring = s.Component<RisingTraceComponent>(1, ("Radius", s.Slider(0, "Radius", 15, 5, 50, 0)), ("Height", s.Slider(0, "Height", 1.2, 1, 40, 1)),
            ("Pitch", s.Slider(0, "Pitch", 0.3, 0.1, 2)), ("Segments Per Turn", s.Slider(0, "Segments", 48, 12, 144, 0)));
        var waves = s.Component<DeformComponent>(2, ("Print Paths", ring), ("System", s.Text(1, "System", "Cylindrical")),
            ("Z", s.Text(1, "New height", "z + 0.1 * z * sin(6 * theta)")));
        var gap = s.Component<GapBeadComponent>(3, ("Print Paths", waves), ("Width", s.Slider(2, "Width", 0.5, 0.2, 2)));
        return Print(s, 5, Moved(s, 4, gap));
    }

    private static GH_Document ModulatedRing(string name)
    {
        var s = new Sketch(name, "A pattern by displacement. A formula pushes the wall in and out along its length.");
        var ring = s.Component<RisingTraceComponent>(1, ("Radius", s.Slider(0, "Radius", 15, 5, 50, 0)), ("Height", s.Slider(0, "Height", 2, 1, 40, 1)),
            ("Pitch", s.Slider(0, "Pitch", 0.25, 0.1, 2)), ("Segments Per Turn", s.Slider(0, "Segments", 72, 12, 144, 0)));
        var pattern = s.Component<ModulateComponent>(2, ("Print Paths", ring), ("Expression", s.Text(1, "Pattern", "0.5 + 0.5 * sin(12 * theta)")),
            ("Mode", s.Text(1, "Mode", "Displace Left")), ("Low", s.Slider(1, "Low", 0, -2, 2)), ("High", s.Slider(1, "High", 0.8, -2, 2)));
        return Print(s, 4, Moved(s, 3, pattern));
    }

    private static GH_Document CustomPrinter(string name)
    {
        var s = new Sketch(name, "Your own printer, material and settings without a file. Values are set by their keys.");
        var printer = s.Component<PrinterComponent>(1, ("Profile", s.Text(0, "Profile", "generic")), ("Nozzle Diameter", s.Slider(0, "Nozzle", 0.6, 0.2, 2)),
            ("max_flow_mm3_s", s.Slider(0, "Maximum flow", 20, 1, 50, 0)), ("print_acceleration_mm_s2", s.Slider(0, "Acceleration", 600, 100, 5000, 0)),
            ("Name", s.Text(0, "Name", "my_printer")));
        var material = s.Component<MaterialComponent>(1, ("Profile", s.Text(0, "Material", "petg")),
            ("Nozzle Temperature", s.Slider(0, "Nozzle temperature", 235, 180, 300, 0)));
        var settings = s.Component<PrintSettingsComponent>(1, ("Layer Height", s.Slider(0, "Layer", 0.3, 0.05, 1)),
            ("Print Speed", s.Slider(0, "Speed", 45, 5, 200, 0)));
        var turtle = s.Component<TurtleComponent>(1, ("Program", s.Text(0, "Script", "jump 60 60 0.3\nbead 0.7 0.3\nrepeat 6 [ forward 20; left 60 ]")));
        var setup = s.Component<PrintSetupComponent>(2, ("Printer", printer), ("Material", material), ("Settings", settings));
        turtle.Params.Input.Single(p => p.Name == "Setup").AddSource(setup.Params.Output[0]);
        return Write(s, 4, s.Component<PlanToolpathComponent>(3, ("Steps", (turtle, "Steps"))));
    }

    private static GH_Document DecodeAndRemix(string name)
    {
        var s = new Sketch(name, "Reads G-code, slows it down, adds a pause at a layer and writes it again. Unedited lines stay byte for byte.");
        var code = s.Text(0, "G-code",
            "; generated by a slicer\nG28\nG90\nM83\nM109 S200\n;LAYER:0\nG1 X60 Y60 Z0.2 F6000\nG1 X100 Y60 E1.5 F1800\nG1 X100 Y100 E1.5\n"
            + ";LAYER:1\nG1 X60 Y60 Z0.4 F6000\nG1 X100 Y60 E1.5 F1800\nG1 X100 Y100 E1.5\nM104 S0\n");
        var decode = s.Component<DecodeGCodeComponent>(1, ("G-code", code), ("Setup", s.Text(0, "Printer", "generic")));
        var edit = s.Component<EditToolpathComponent>(2, ("Toolpath", decode),
            ("Filter", s.Component<MoveFilterComponent>(1, ("First Layer", s.Slider(0, "First layer", 1, 0, 10, 0)))),
            ("Speed Factor", s.Slider(1, "Speed", 0.5, 0.1, 2)));
        var pause = s.Component<InsertAtLayerComponent>(3, ("Toolpath", edit), ("Layers", s.Slider(2, "Layer", 1, 0, 10, 0)),
            ("Text", s.Text(2, "Message", "Insert the nut")));
        return Write(s, 4, pause);
    }

    private static GH_Document Simulate(string name)
    {
        var s = new Sketch(name, "A print in motion. Drag the slider, or connect Play to Position and switch Run off and on.");
        var plan = Ring(s);
        s.Component<SimulateComponent>(4, ("Toolpath", plan), ("Position", s.Slider(3, "Position", 0.42, 0, 1, 3)));
        s.Component<PlayComponent>(4, ("Toolpath", plan), ("Run", s.Toggle(3, "Run")), ("Speed", s.Slider(3, "Speed", 20, 1, 200, 0)));
        s.Component<StatisticsComponent>(4, ("Toolpath", plan));
        s.Component<ToolpathPreviewComponent>(4, ("Toolpath", plan), ("Color By", s.Text(3, "Color by", "Time")), ("Travel", s.Toggle(3, "Travel")));
        return Write(s, 5, plan);
    }

    private static GH_Document Check(string name)
    {
        var s = new Sketch(name, "A check before printing. Change the panel X to x + 215: the ring leaves the bed, and Check refuses it. Points show where.");
        var plan = Ring(s);
        var check = s.Component<CheckComponent>(4, ("Toolpath", plan));
        return Write(s, 5, check);
    }

    private static GH_Document Bake(string name)
    {
        var s = new Sketch(name, "Extrusions as Rhino objects. Switch Bake off and on. Baking again replaces the objects.");
        var plan = Ring(s);
        s.Component<BakeToolpathComponent>(4, ("Toolpaths", plan), ("Name", s.Text(3, "Name", "Ring")), ("Bake", s.Toggle(3, "Bake")),
            ("Kind", s.Text(3, "Kind", "Beads")));
        s.Component<DeconstructToolpathComponent>(4, ("Toolpath", plan));
        return Write(s, 5, plan);
    }

    private static GH_Document PlanarSlice(string name)
    {
        var s = new Sketch(name, "A model from a file, arranged on the bed and sliced into planar layers.");
        var (models, setup) = Model(s, "../models/bracket.stl", 0.3, null, "infill_density_percent=15");
        return Print(s, 6, s.Component<PlanarSlicerComponent>(5, ("Geometry", models), ("Setup", setup)));
    }

    private static GH_Document Vase(string name)
    {
        var s = new Sketch(name, "A vase as one continuous rising wall. Spiral vase is a setting of the planar slicer.");
        var (models, setup) = Model(s, "../models/vase.stl", 0.6, 0.8, "spiral_vase=true", "line_width_mm=0.8");
        return Print(s, 6, s.Component<PlanarSlicerComponent>(5, ("Geometry", models), ("Setup", setup)));
    }

    private static GH_Document CurvedRoof(string name)
    {
        var s = new Sketch(name, "Layers that follow the roof of the model. They are level on the bed, and parallel to the roof from Blend To on.");
        var (models, setup) = Model(s, "../models/saddle_roof.stl", 0.6, 0.8, "infill_density_percent=10", "line_width_mm=0.8", "skirt_loops=0");
        var field = s.Component<LayerFieldComponent>(4, ("Surfaces", models), ("Blend From", s.Slider(3, "Level up to", 2, 0, 20)),
            ("Blend To", s.Slider(3, "Curved from", 18, 1, 40)));
        return Print(s, 6, s.Component<CurvedSlicerComponent>(5, ("Geometry", models), ("Field", field), ("Setup", setup)));
    }

    private static GH_Document BetweenBoundaries(string name)
    {
        var s = new Sketch(name, "The same number of layers everywhere between the bed and the roof. Layers are thicker in high places, and each "
            + "bead has its own volume.");
        var (models, setup) = Model(s, "../models/saddle_roof.stl", 0.6, 0.8, "infill_density_percent=10", "line_width_mm=0.8", "skirt_loops=0");
        var field = s.Component<LayerFieldComponent>(4, ("Kind", s.Text(3, "Kind", "Between")), ("Surfaces", models));
        return Print(s, 6, s.Component<CurvedSlicerComponent>(5, ("Geometry", models), ("Field", field), ("Setup", setup)));
    }

    private static GH_Document PrintOnTerrain(string name)
    {
        var s = new Sketch(name, "A drawing on a piece of terrain on the bed. The paths follow its surface, travel moves stay above it.");
        var terrain = Placed(s, "../models/terrain.stl");
        var setup = s.Component<PrintSetupComponent>(3, ("Printer", s.Text(2, "Printer", "generic")), ("Printed On", terrain));
        var spiral = s.Component<RoundTraceComponent>(2, ("Kind", s.Text(1, "Kind of floor", "Spiral")),
            ("Radius", s.Slider(1, "Radius", 6, 2, 50, 0)), ("Pitch", s.Slider(1, "Pitch", 3, 0.5, 10)));
        var project = s.Component<ProjectPathsComponent>(4, ("Print Paths", Moved(s, 3, spiral)), ("Setup", setup),
            ("Offset", s.Slider(3, "Offset", -0.05, -0.5, 1)),
                ("Partial", s.Add(3, new Grasshopper.Kernel.Special.GH_BooleanToggle { NickName = "Partial", Value = true })));
        return Write(s, 6, s.Component<PlanToolpathComponent>(5, ("Steps", project), ("Setup", setup)));
    }

    private static GH_Document GlobeFromImage(string name)
    {
        var s = new Sketch(name, "A globe from an image. White areas get less flow, so extrusions are thinner there. The sphere is a deformed helix.");
        var helix = s.Component<RisingTraceComponent>(1, ("Radius", s.Slider(0, "Radius", 10, 5, 50, 0)), ("Height", s.Slider(0, "Height", 12, 1, 40, 1)),
            ("Pitch", s.Slider(0, "Pitch", 1, 0.1, 2)), ("Segments Per Turn", s.Slider(0, "Segments", 48, 12, 144, 0)));
        var sphere = s.Component<DeformComponent>(2, ("Print Paths", helix), ("System", s.Text(1, "System", "Cylindrical")),
            ("R", s.Text(1, "New radius", "sqrt(64 - (z - 6) ^ 2) + r - 10")));
        var image = s.Component<ModulateComponent>(3, ("Print Paths", sphere), ("Source", s.Text(2, "Source", "Image")),
            ("Image", s.Text(2, "Image", "../turtle/world_map.pbm")),
            ("Mode", s.Text(2, "Mode", "Flow")), ("Low", s.Slider(2, "Black", 1, 0.1, 2)), ("High", s.Slider(2, "White", 0.65, 0.1, 2)),
            ("Mapping", s.Text(2, "Mapping", "Globe")));
        return Print(s, 5, Moved(s, 4, image));
    }

    private static GH_Document UserCurves(string name)
    {
        var s = new Sketch(name, "Curves from a file, printed exactly as drawn, in file order. Nothing is added.");
        var setup = s.Component<PrintSetupComponent>(1, ("Printer", s.Text(0, "Printer", "pen_plotter")));
        var curves = s.Component<ReadCurvesComponent>(2, ("File", s.Text(1, "File", "../curves/calligraphy.svg")), ("Setup", setup));
        var plan = s.Component<PlanToolpathComponent>(3, ("Steps", (curves, "Steps")), ("Mode", s.Text(2, "Mode", "As Drawn")));
        return Write(s, 4, plan);
    }

    private static GH_Document CheckAndRepair(string name)
    {
        var s = new Sketch(name, "Checks a file of another program. Its last layer is too fast for the printer. Slowed down, it passes. Set Speed to 1, "
            + "and Check turns red.");
        var code = s.Text(0, "G-code",
            "; generated by a slicer\nG28\nG90\nM83\nM109 S200\n;LAYER:0\nG1 X60 Y60 Z0.2 F6000\nG1 X100 Y60 E1.5 F1800\nG1 X100 Y100 E1.5\n"
            + ";LAYER:1\nG1 X60 Y60 Z0.4 F6000\nG1 X100 Y60 E1.5 F90000\nG1 X100 Y100 E1.5\nM104 S0\n");
        var decode = s.Component<DecodeGCodeComponent>(1, ("G-code", code), ("Setup", s.Text(0, "Printer", "generic")));
        var repaired = s.Component<EditToolpathComponent>(2, ("Toolpath", decode),
            ("Filter", s.Component<MoveFilterComponent>(1, ("First Layer", s.Slider(0, "From layer", 1, 0, 10, 0)))),
            ("Speed Factor", s.Slider(1, "Speed", 0.02, 0.01, 2)));
        return Write(s, 4, s.Component<CheckComponent>(3, ("Toolpath", repaired)));
    }

    private static ArrangeModelsComponent Placed(Sketch s, string file)
        => s.Component<ArrangeModelsComponent>(2, ("Geometry", s.Component<ReadModelComponent>(1, ("File", s.Text(0, "File", file)))));

    private static (ArrangeModelsComponent Models, PrintSetupComponent Setup) Model(
        Sketch s, string file, double layer, double? nozzle, params string[] values)
    {
        var models = Placed(s, file);
        var keys = values.Select(v => v.Split('=')).Select(v => (v[0], (object)s.Text(2, v[0], v[1])));
        var settings = s.Component<PrintSettingsComponent>(3, [("Layer Height", s.Slider(2, "Layer", layer, 0.05, 1)), .. keys]);
        GH_Component printer = nozzle is { } d ? s.Component<PrinterComponent>(3, ("Nozzle Diameter", s.Slider(2, "Nozzle", d, 0.2, 3)))
            : s.Component<PrinterComponent>(3);
        return (models, s.Component<PrintSetupComponent>(4, ("Printer", printer), ("Settings", settings)));
    }

    private static PlanToolpathComponent Ring(Sketch s)
    {
        var ring = s.Component<RisingTraceComponent>(1, ("Radius", s.Slider(0, "Radius", 12, 5, 50, 0)), ("Height", s.Slider(0, "Height", 1, 1, 40, 1)),
            ("Pitch", s.Slider(0, "Pitch", 0.25, 0.1, 2)), ("Segments Per Turn", s.Slider(0, "Segments", 36, 12, 144, 0)));
        return s.Component<PlanToolpathComponent>(3, ("Steps", Moved(s, 2, ring)), ("Setup", s.Text(2, "Printer", "generic")));
    }

    private static DeformComponent Moved(Sketch s, int column, GH_Component paths)
        => s.Component<DeformComponent>(column, ("Print Paths", paths), ("X", s.Text(column - 1, "X", ToBed)), ("Y", s.Text(column - 1, "Y", "y + 110")),
            ("Z", s.Text(column - 1, "Z", "z + 0.2")));

    private static GH_Document Print(Sketch s, int column, object steps)
        => Write(s, column + 1, s.Component<PlanToolpathComponent>(column, ("Steps", steps)));

    private static GH_Document Write(Sketch s, int column, GH_Component toolpath)
    {
        var write = s.Component<GenerateGCodeComponent>(column, ("Toolpath", toolpath));
        s.Component<GCodeTextComponent>(column + 1, ("G-code", write));
        s.Component<SaveGCodeComponent>(column + 1, ("G-code", write), ("File", s.Text(column, "File", "example.gcode")), ("Save", s.Toggle(column, "Save")),
            ("Overwrite", s.Toggle(column, "Overwrite")));
        return s.Finish();
    }
}
