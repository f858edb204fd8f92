using Caterpillar.GH.Components.Design;
using Caterpillar.GH.Components.GCode;
using Caterpillar.GH.Components.Path;
using Caterpillar.GH.Components.Setup;

namespace Caterpillar.GH.Tests.Examples;

/// <summary>Definitions that shape paths without slicing.</summary>
internal static class TraceDefinitions
{
    public static Sketch HelixToSphere(string name)
    {
        var s = new Sketch(name, "A helix becomes a barrel: the radius grows with the height and shrinks again. Shapes without slicing, after Kanada.",
            "the formula of the new radius: r is the old one, z the height, theta the angle.");
        var setup = s.Setup();
        var helix = Helix(s, setup, 15, 4, 0.2, 36);
        s.Stage("Shape");
        var round = s.Component<DeformComponent>(("Print Paths", helix), ("System", new Pick("Cylindrical")), ("R", s.Text("New radius",
            "r + 0.2 * z * (4.2 - z)", width: 190)), ("Plane", Bed(s)));
        return s.Print(round, "Layer");
    }

    public static Sketch CupWithSkirt(string name)
    {
        var s = new Sketch(name, "A cup: first a skirt, then a spiral floor, then a widening wall. Paths of several sources are printed in the order "
            + "of the wires.",
            "the top radius and the height of the wall.");
        var setup = s.Setup();
        s.Stage("Design");
        var center = Bed(s);
        var skirt = s.With<RoundTraceComponent>(setup, ("Kind", new Pick("Skirt")), ("Plane", center), ("Radius", s.Slider("Skirt radius", 22, 10, 60, 0)),
            ("Loop Count", s.Slider("Skirt loops", 2, 1, 10, 0)));
        var floor = s.With<RoundTraceComponent>(setup, ("Kind", new Pick("Spiral")), ("Plane", center), ("Radius", s.Slider("Floor radius", 15, 5, 50, 0)),
            ("Pitch", s.Slider("Floor spacing", 0.5, 0.2, 2, 2)));
        var wall = s.With<RisingTraceComponent>(setup, ("Kind", new Pick("Cone")), ("Plane", center), ("Bottom Radius", s.Slider("Bottom radius", 15, 5, 50,
            0)), ("Top Radius", s.Slider("Top radius", 18, 5, 50, 0)),
            ("Height", s.Slider("Wall height", 2, 1, 40)), ("Pitch", s.Slider("Rise per turn", 0.25, 0.1, 1, 2)));
        return s.Print(new object[] { skirt, floor, wall }, "Order");
    }

    public static Sketch GapBead(string name)
    {
        var s = new Sketch(name, "Waves on a flat ring. Each extrusion gets the material that fills the gap below it.",
            "the number of waves, 6, in the formula, and the bead width. Color shows the flow.");
        var setup = s.Setup();
        var ring = Helix(s, setup, 15, 1.2, 0.3, 48);
        s.Stage("Shape");
        var waves = s.Component<DeformComponent>(("Print Paths", ring), ("System", new Pick("Cylindrical")), ("Z", s.Text("New height",
            "z + 0.1 * z * sin(6 * theta)", width: 220)), ("Plane", Bed(s)));
        var gap = s.Component<GapBeadComponent>(("Print Paths", waves), ("Width", s.Slider("Bead width", 0.5, 0.2, 2, 2)));
        return s.Print(gap, "Flow");
    }

    public static Sketch ModulatedRing(string name)
    {
        var s = new Sketch(name, "A pattern by displacement. A formula pushes the wall in and out along its length.",
            "the formula, and how far High pushes out.");
        var setup = s.Setup();
        var ring = Helix(s, setup, 15, 2, 0.25, 72);
        s.Stage("Shape");
        var pattern = s.Component<ModulateComponent>(("Print Paths", ring), ("Mode", new Pick("Displace Left")), ("Expression", s.Text("Pattern",
            "0.5 + 0.5 * sin(12 * theta)", width: 210)),
            ("Low", s.Slider("Low", 0, -2, 2, 2)), ("High", s.Slider("High", 0.8, -2, 2, 2)), ("Plane", Bed(s)));
        return s.Print(pattern, "Layer");
    }

    public static Sketch GlobeFromImage(string name)
    {
        var s = new Sketch(name, "A globe from an image. White areas get less flow, so extrusions are thinner there. The sphere is a deformed helix.",
            "the image, and the flow at White.");
        var setup = s.Setup();
        var helix = Helix(s, setup, 10, 12, 0.25, 48);
        s.Stage("Shape");
        var sphere = s.Component<DeformComponent>(("Print Paths", helix), ("System", new Pick("Cylindrical")), ("R", s.Text("New radius",
            "sqrt(64 - (z - 6) ^ 2) + r - 10", width: 230)), ("Plane", Bed(s)));
        var image = s.Component<ModulateComponent>(("Print Paths", sphere), ("Source", new Pick("Image")), ("Mapping", new Pick("Globe")), ("Mode",
            new Pick("Flow")), ("Image", s.Text("Image", "../turtle/world_map.png", width: 180)),
            ("Low", s.Slider("Flow at black", 1, 0.1, 2, 2)), ("High", s.Slider("Flow at white", 0.65, 0.1, 2, 2)), ("Plane", Bed(s)));
        return s.Print(image, "Flow");
    }

    public static Sketch UserCurves(string name)
    {
        var s = new Sketch(name, "Curves from a file, printed exactly as drawn, in file order. Nothing is added.",
            "the file, or Mode: Printer adds retraction and lifts.");
        var setup = s.Setup("pen_plotter");
        s.Stage("Design");
        var curves = s.With<ReadCurvesComponent>(setup, ("File", s.Text("File", "../curves/calligraphy.svg", width: 180)));
        s.Stage("Plan");
        var plan = s.Component<PlanToolpathComponent>(("Steps", (curves, "Steps")), ("Mode", new Pick("As Drawn")));
        return s.Finish(plan, "Order");
    }

    public static Sketch CooledTower(string name)
    {
        var s = new Sketch(name, "A small tower whose layers get time to cool: short layers are printed more slowly. Arcs then replace its many short lines.",
            "the least time of a layer. Color shows the speed.");
        var setup = s.Setup();
        s.Stage("Design");
        var center = Bed(s);
        var bead = s.Component<ConstructBeadComponent>(("Width", s.Slider("Bead width", 0.5, 0.2, 2, 2)), ("Height", s.Slider("Bead height", 0.25, 0.1, 1, 2)),
            ("Speed", s.Slider("Speed", 9, 1, 60, 0)));
        var wall = s.With<RisingTraceComponent>(setup, ("Kind", new Pick("Cylinder")), ("Plane", center), ("Radius", s.Slider("Radius", 2.8, 1, 50)),
            ("Height", s.Slider("Height", 3, 1, 40)), ("Pitch", s.Slider("Layer height", 0.25, 0.1, 1, 2)),
            ("Horizontal Pitch", s.Slider("Line spacing", 0.5, 0.2, 2, 2)), ("Bead", bead), ("Segments Per Turn", s.Slider("Segments", 12, 8, 144, 0)));
        s.Stage("Path");
        var cool = s.Component<CoolLayersComponent>(("Print Paths", wall), ("Minimum Layer Time", s.Slider("Layer time, s", 8, 0, 30,
            0)));
        var arcs = s.Component<FitArcsComponent>(("Print Paths", cool), ("Tolerance", s.Slider("Tolerance", 0.1, 0.001, 0.2, 3)));
        s.Show("Speeds, mm/s", s.Component<DeconstructPrintPathComponent>(("Print Path", arcs)), "Speeds", 6, 120);
        return s.Print(arcs, "Speed");
    }

    public static Sketch RhinoCurves(string name)
    {
        var s = new Sketch(name, "Curves drawn in Rhino become print paths. They are inside this file; set the parameter to your own by right-clicking it.",
            "width and height of the bead, and the rule by which paths are sorted. The panel shows the travel that sorting leaves.");
        var setup = s.Setup();
        s.Stage("Design");
        var curves = s.Curve("Curves", Solids.Rosette(70, 80, 18, 5, 6, 0.3), Solids.Rosette(150, 140, 18, 5, 4, 0.3), Solids.Rosette(70, 140, 12, 3, 8, 0.3),
            Solids.Rosette(150, 80, 12, 3, 5, 0.3));
        var raised = s.Component<SubdivideCurveComponent>(("Curve", curves), ("Mode", new Pick("Angle")), ("Angle", s.Slider("Largest turn", 12, 1, 45, 0)));
        s.Show("Points", raised, "Points", 5, 230);
        s.Stage("Path");
        var bead = s.Component<ConstructBeadComponent>(("Width", s.Slider("Bead width", 0.8, 0.3, 3, 2)), ("Height", s.Slider("Bead height", 0.3, 0.1, 2, 2)),
            ("Speed", s.Slider("Speed", 25, 5, 100, 0)));
        var paths = s.With<ConstructPrintPathComponent>(setup, ("Curve", curves), ("Bead", bead));
        var merged = s.Component<MergePathsComponent>(("Print Paths", paths), ("Tolerance", s.Slider("Join within", 0.1, 0, 1, 2)));
        var sorted = s.Component<SortPathsComponent>(("Print Paths", merged), ("Rule", new Pick("Nearest")), ("Rotate", s.Toggle("Move starts", true)));
        s.Show("Travel, mm", sorted, "Travel", 1, 110);
        return s.Print(sorted, "Order");
    }

    private static object Helix(Sketch s, PrintSetupComponent setup, double radius, double height, double pitch, int segments)
    {
        s.Stage("Design");
        return s.With<RisingTraceComponent>(setup, ("Kind", new Pick("Helix")), ("Plane", Bed(s)), ("Radius", s.Slider("Radius", radius, 5, 50, 0)),
            ("Height", s.Slider("Height", height, 1, 40)),
            ("Pitch", s.Slider("Rise per turn", pitch, 0.1, 2, 2)), ("Segments Per Turn", s.Slider("Segments", segments, 12, 144, 0)));
    }

    private static object Bed(Sketch s) => s.Point("Bed center", 110, 110, 0.2);
}
