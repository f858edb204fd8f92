using Caterpillar.GH.Components.Design;
using Caterpillar.GH.Components.GCode;
using Caterpillar.GH.Components.Path;

namespace Caterpillar.GH.Tests.Examples;

/// <summary>Definitions that shape paths without slicing.</summary>
internal static class TraceDefinitions
{
    public static Sketch HelixToSphere(string name)
    {
        var s = new Sketch(name, "A helix becomes a barrel: the radius grows with the height and shrinks again. Shapes without slicing, after Kanada.",
            "the formula of the new radius: r is the old one, z the height, theta the angle.");
        var setup = s.Setup();
        var helix = Helix(s, 15, 4, 0.4, 36);
        s.Stage("Shape");
        var round = s.Component<DeformComponent>(("Print Paths", helix), ("X", s.Text("New radius", "r + 0.5 * z * (4.2 - z)", width: 190)), ("Plane", Bed(s)));
        s.Choose(round, "System", "Cylindrical");
        return s.Print(round, setup, "Layer");
    }

    public static Sketch CupWithSkirt(string name)
    {
        var s = new Sketch(name, "A cup: first a skirt, then a spiral floor, then a widening wall. Paths of several sources are printed in the order of the wires.",
            "the top radius and the height of the wall.");
        var setup = s.Setup();
        s.Stage("Design");
        var center = Bed(s);
        var skirt = s.Component<SkirtTraceComponent>(("Plane", center), ("Radius", s.Slider("Skirt radius", 22, 10, 60, 0)), ("Loop Count", s.Slider("Skirt loops", 2, 1, 10, 0)));
        var floor = s.Component<SpiralTraceComponent>(("Plane", center), ("Radius", s.Slider("Floor radius", 15, 5, 50, 0)), ("Pitch", s.Slider("Floor spacing", 0.5, 0.2, 2, 2)));
        var wall = s.Component<ConeTraceComponent>(("Plane", center), ("Bottom Radius", s.Slider("Bottom radius", 15, 5, 50, 0)), ("Top Radius", s.Slider("Top radius", 18, 5, 50, 0)),
            ("Height", s.Slider("Wall height", 2, 1, 40)), ("Pitch", s.Slider("Rise per turn", 0.25, 0.1, 1, 2)));
        return s.Print(new object[] { skirt, floor, wall }, setup, "Order");
    }

    public static Sketch GapBead(string name)
    {
        var s = new Sketch(name, "Waves on a flat ring. Each extrusion gets the material that fills the gap below it.",
            "the number of waves, 6, in the formula, and the bead width. Color shows the flow.");
        var setup = s.Setup();
        var ring = Helix(s, 15, 1.2, 0.3, 48);
        s.Stage("Shape");
        var waves = s.Component<DeformComponent>(("Print Paths", ring), ("Z", s.Text("New height", "z + 0.1 * z * sin(6 * theta)", width: 220)), ("Plane", Bed(s)));
        s.Choose(waves, "System", "Cylindrical");
        var gap = s.Component<GapBeadComponent>(("Print Paths", waves), ("Width", s.Slider("Bead width", 0.5, 0.2, 2, 2)));
        return s.Print(gap, setup, "Flow");
    }

    public static Sketch ModulatedRing(string name)
    {
        var s = new Sketch(name, "A pattern by displacement. A formula pushes the wall in and out along its length.",
            "the formula, and how far High pushes out.");
        var setup = s.Setup();
        var ring = Helix(s, 15, 2, 0.25, 72);
        s.Stage("Shape");
        var pattern = s.Component<ModulateComponent>(("Print Paths", ring), ("Expression", s.Text("Pattern", "0.5 + 0.5 * sin(12 * theta)", width: 210)),
            ("Low", s.Slider("Low", 0, -2, 2, 2)), ("High", s.Slider("High", 0.8, -2, 2, 2)), ("Plane", Bed(s)));
        s.Choose(pattern, "Mode", "Displace Left");
        return s.Print(pattern, setup, "Layer");
    }

    public static Sketch GlobeFromImage(string name)
    {
        var s = new Sketch(name, "A globe from an image. White areas get less flow, so extrusions are thinner there. The sphere is a deformed helix.",
            "the image, and the flow at White.");
        var setup = s.Setup();
        var helix = Helix(s, 10, 12, 1, 48);
        s.Stage("Shape");
        var bed = Bed(s);
        var sphere = s.Component<DeformComponent>(("Print Paths", helix), ("X", s.Text("New radius", "sqrt(64 - (z - 6) ^ 2) + r - 10", width: 230)), ("Plane", bed));
        s.Choose(sphere, "System", "Cylindrical");
        var image = s.Component<ModulateComponent>(("Print Paths", sphere), ("Image", s.Text("Image", "../turtle/world_map.pbm", width: 180)),
            ("Low", s.Slider("Flow at black", 1, 0.1, 2, 2)), ("High", s.Slider("Flow at white", 0.65, 0.1, 2, 2)), ("Plane", bed));
        s.Choose(image, "Mode", "Flow");
        s.Choose(image, "Mapping", "Globe");
        return s.Print(image, setup, "Flow");
    }

    public static Sketch UserCurves(string name)
    {
        var s = new Sketch(name, "Curves from a file, printed exactly as drawn, in file order. Nothing is added.",
            "the file, or Mode: Printer adds retraction and lifts.");
        var setup = s.Setup("pen_plotter");
        s.Stage("Design");
        var curves = s.Component<ReadCurvesComponent>(("File", s.Text("File", "../curves/calligraphy.svg", width: 180)));
        s.Stage("Plan");
        var plan = s.With<PlanToolpathComponent>(setup, ("Steps", (curves, "Steps")));
        s.Choose(plan, "Mode", "As Drawn");
        return s.Finish(plan, "Order");
    }

    private static object Helix(Sketch s, double radius, double height, double pitch, int segments)
    {
        s.Stage("Design");
        return s.Component<HelixTraceComponent>(("Plane", Bed(s)), ("Radius", s.Slider("Radius", radius, 5, 50, 0)), ("Height", s.Slider("Height", height, 1, 40)),
            ("Pitch", s.Slider("Rise per turn", pitch, 0.1, 2, 2)), ("Segments Per Turn", s.Slider("Segments", segments, 12, 144, 0)));
    }

    private static object Bed(Sketch s) => s.Point("Bed center", 110, 110, 0.2);
}
