using Caterpillar.GH.Components.Design;

namespace Caterpillar.GH.Tests.Examples;

/// <summary>Definitions that draw with a turtle.</summary>
internal static class TurtleDefinitions
{
    public static Sketch Star(string name)
    {
        var s = new Sketch(name, "A star drawn by a turtle. The script in the panel is the drawing: jump to the bed, set the bead, then go forward and turn.",
            "the number of points, and the length 40 in the script. Drag Position to see the turtle draw.");
        var setup = s.Setup();
        s.Stage("Design");
        var script = s.Text("Script", "param points = 7\njump 110 110 0.2\nbead 0.5 0.2\nspeed 30\nrepeat points [\n  forward 40\n  left 180 - 180 / "
            + "points\n]", width: 220);
        var program = s.Component<TurtleProgramComponent>(("Script", script), ("Variables", s.Text("Variables", "points=9", lines: true, width: 120)));
        var turtle = s.With<TurtleComponent>(setup, ("Program", program));
        s.Component<TurtlePreviewComponent>(("Steps", (turtle, "Steps")), ("Position", s.Slider("Position", 0.75, 0, 1, 2)));
        return s.Print((turtle, "Steps"), "Order");
    }

    public static Sketch Commands(string name)
    {
        var s = new Sketch(name, "A turtle program from components instead of a script: forward and turn, repeated to a polygon, after a small pause.",
            "Sides and Turn together: 5 and 72 give a pentagon, 5 and 144 a star.");
        var setup = s.Setup();
        s.Stage("Design");
        var jump = s.Component<TurtleMoveComponent>(("Kind", new Pick("Jump")), ("Point", s.Point("Start", 90, 90, 0.2)));
        var bead = s.Component<TurtleExtrusionComponent>(("Kind", new Pick("Width And Height")), ("Value", s.Slider("Width", 0.5, 0.2, 2, 2)), ("Height",
            s.Slider("Height", 0.2, 0.1, 1, 2)),
            ("Speed", s.Slider("Speed", 25, 1, 100, 0)));
        var pen = s.Component<TurtlePenComponent>(("Down", s.Toggle("Pen down", true)));
        var wait = s.Component<TurtleEventComponent>(("Kind", new Pick("Dwell")), ("Value", s.Slider("Wait, ms", 500, 0, 5000, 0)));
        var forward = s.Component<TurtleMoveComponent>(("Distance", s.Slider("Side", 30, 5, 80, 0)));
        var turn = s.Component<TurtleRotateComponent>(("Yaw", s.Slider("Turn", 90, 0, 180, 0)));
        var square = s.Component<TurtleRepeatComponent>(("Commands", new object[] { forward, turn }), ("Count", s.Slider("Sides", 4, 1, 12, 0)));
        s.Stage("Shape");
        var program = s.Component<TurtleProgramComponent>(("Commands", new object[] { jump, bead, pen, wait, square }));
        var turtle = s.With<TurtleComponent>(setup, ("Program", program));
        return s.Print((turtle, "Steps"), "Order");
    }

    public static Sketch Tree(string name)
    {
        var s = new Sketch(name, "A branching tree as an L-system. F draws, + and - turn, [ and ] branch and return above the print.",
            "Angle, Generations, and the rule: F -> F[+F]F[-F]F becomes a bush with F -> FF[+F][-F].");
        var setup = s.Setup();
        s.Stage("Design");
        var system = s.Component<LSystemComponent>(("Axiom", s.Text("Axiom", "F", width: 80)), ("Rules", s.Text("Rules", "F -> F[+F]F[-F]F", lines: true,
            width: 160)),
            ("Generations", s.Slider("Generations", 3, 0, 5, 0)), ("Angle", s.Slider("Angle", 25.7, 0, 90)), ("Step", s.Slider("Step", 2, 0.5, 10)));
        s.Show("Word", system, "Text", 5, 220);
        s.Stage("Shape");
        var turtle = s.With<TurtleComponent>(setup, ("Program", system), ("Start Plane", s.Point("Root", 60, 110, 0.2)));
        return s.Print((turtle, "Steps"), "Order");
    }
}
