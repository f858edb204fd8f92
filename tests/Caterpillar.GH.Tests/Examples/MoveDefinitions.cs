using Caterpillar.GH.Components.Design;
using Caterpillar.GH.Components.GCode;
using Caterpillar.GH.Components.Path;
using Caterpillar.GH.Components.Setup;
using Caterpillar.GH.Components.Simulate;

namespace Caterpillar.GH.Tests.Examples;

/// <summary>Definitions that decide about single moves: numbers along curves, events between them, toolpaths from moves.</summary>
internal static class MoveDefinitions
{
    public static Sketch FlatDrawing(string name)
    {
        var s = new Sketch(name, "Curves drawn flat on the ground become a print of several layers. The first is raised to its height above the bed.",
            "the number of layers, and Base: As Drawn leaves the curve at Z 0, where the nozzle touches the bed.");
        var setup = s.Setup();
        s.Stage("Design");
        var curves = s.Curve("Flat curves", Solids.Rosette(80, 110, 22, 6, 5, 0), Solids.Rosette(145, 110, 22, 6, 7, 0));
        s.Stage("Path");
        var paths = s.With<ConstructPrintPathComponent>(setup, ("Curve", curves), ("Base", new Pick("Bed")), ("Layer Count", s.Slider("Layers", 4, 1, 50, 0)));
        s.Show("Notes", paths, "Diagnostics", 4, 300);
        return s.Print((paths, "Layers"), "Layer");
    }

    public static Sketch WidthsAndEvents(string name)
    {
        var s = new Sketch(name, "One curve whose width changes from vertex to vertex, and one that follows after a pause. Steps between curves happen in the "
            + "order of the wires.",
            "the widths, one line for each vertex, and the message of the pause. Color shows the width.");
        var setup = s.Setup();
        s.Stage("Design");
        var wide = s.Curve("Curve with widths", RhinoBytes.Polyline([new(60, 80, 0), new(80, 120, 0), new(100, 80, 0), new(120, 120, 0), new(140, 80, 0)]));
        var even = s.Curve("Second curve", RhinoBytes.Polyline([new(60, 140, 0), new(140, 140, 0)]));
        s.Stage("Path");
        var first = s.With<ConstructPrintPathComponent>(setup, ("Curve", wide), ("Widths", s.Text("Widths, mm", "0.4\n0.9\n0.4\n0.9\n0.4", true, 100)),
            ("Speeds", s.Slider("Speed", 20, 5, 100, 0)));
        var parts = s.Component<DeconstructPrintPathComponent>(("Print Path", first));
        s.Show("Widths of segments, mm", parts, "Widths", 6, 170);
        var second = s.With<ConstructPrintPathComponent>(setup, ("Curve", even));
        var heat = s.Component<StepComponent>(("Kind", new Pick("Nozzle Temperature", "First step")),
            ("Temperature", s.Slider("Temperature", 195, 150, 300, 0)));
        var pause = s.Component<StepComponent>(("Kind", new Pick("Pause", "Second step")), ("Text", s.Text("Message", "Put the beads in", width: 130)));
        return s.Print(new object[] { first, heat, pause, second }, "Width");
    }

    public static Sketch FramesForRobots(string name)
    {
        var s = new Sketch(name, "A toolpath as planes for robots. It is taken apart, made again with another speed, and merged with a second one.",
            "the speed, and the order of the wires into Merge Toolpaths. Save writes a page for the browser, Open shows it.");
        var setup = s.Setup();
        var (left, right) = (Ring(s, setup, "Left", 80), Ring(s, setup, "Right", 140));
        s.Stage("Edit");
        var apart = s.Component<DeconstructToolpathComponent>(("Toolpath", left));
        var made = s.With<ConstructToolpathComponent>(setup, ("Points", (apart, "Points")), ("E Values", (apart, "E Values")), ("Speeds",
            s.Slider("Speed", 25, 5, 100, 0)), ("Kinds", (apart, "Kinds")), ("Roles", (apart, "Roles")));
        var merged = s.Component<MergeToolpathsComponent>(("Toolpaths", new object[] { made, right }));
        s.Stage("Look");
        s.Component<ViewerPageComponent>(("Toolpath", merged), ("File", s.Text("Page", "example.html", width: 120)), ("Save", s.Button("Save page")),
            ("Open", s.Button("Open page")));
        var frames = s.Component<ToolpathFramesComponent>(("Toolpath", merged));
        s.Show("Planes", frames, "Planes", 6, 300);
        s.Show("Flows, mm³/s", frames, "Flows", 6, 110);
        return s.Write(merged);
    }

    private static PlanToolpathComponent Ring(Sketch s, PrintSetupComponent setup, string side, double x)
    {
        s.Stage("Design");
        var ring = s.With<RisingTraceComponent>(setup, ("Kind", new Pick("Helix", side + " shape")), ("Plane", s.Point(side + " center", x, 110, 0.2)),
            ("Radius", s.Slider(side + " radius", 12, 5, 25, 0)), ("Height", s.Slider(side + " height", 1, 1, 20)),
            ("Segments Per Turn", s.Slider(side + " segments", 36, 12, 144, 0)));
        s.Stage("Plan");
        return s.Component<PlanToolpathComponent>(("Steps", ring));
    }
}
