namespace Caterpillar.GH.Components.Design;

/// <summary>Shows a turtle along its path.</summary>
public sealed class TurtlePreviewComponent() : CaterpillarComponent(
    "Turtle Preview", "TPrev", "Shows the turtle as a triangle at a position on its path, and the extrusions up to there.", Panel.Design, GH_Exposure.secondary)
{
    private static readonly Color PrintedColor = Color.FromArgb(214, 110, 40);
    private static readonly PrintSetup Standard = new();
    private static readonly Color OutlineColor = Color.FromArgb(30, 120, 60);
    private DisplayMaterial? _shade;

    public override Guid ComponentGuid => new("0c2ee4b5-6d4e-4b27-9f3f-0f5f5a6e2d13");

    private protected override bool DrawsItself => true;

    // A material belongs to the display, so it is made with the first frame.
    private DisplayMaterial Shade => _shade ??= new DisplayMaterial(Color.FromArgb(60, 170, 90));

    private protected override void Inputs(InputPorts ports)
    {
        ports.Add(new StepParam(), "Steps", "S", "Steps of a turtle, or print paths.", GH_ParamAccess.list);
        ports.Number("Position", "t", "Position along the path by length, from 0 to 1.", 1);
        ports.Number("Size", "Sz", "Half the width of the triangle, in mm.", 2);
    }

    private protected override void Outputs(OutputPorts ports)
    {
        // The component draws it itself.
        ports.Add(new Param_Curve { Hidden = true }, "Triangle", "T", "Turtle as a closed triangle that points forward.");
        ports.Add(new Param_Plane(), "Plane", "Pl", "Pose of the turtle: X points forward, Y left.");
    }

    private protected override void Solve(Run run)
    {
        var part = run.Finite(1);
        if (part is < 0 or > 1) throw new InputProblem("Position must be from 0 to 1.");
        var size = run.Positive(2);
        var steps = run.Steps(run.Some<StepGoo>(0), Standard).Steps;
        var units = run.Units;
        var timeline = run.Work("Drawing", [steps], (_, _) => new TurtleTimeline(steps));
        var printed = run.Work("Drawing", [timeline, units.ToMillimeters], (_, _) => new PrintedLines(timeline.Moves.Count, (i, lines) =>
        {
            var move = timeline.Moves[i];
            if (move.Prints) RhinoGeometry.AddLines(lines, move.From, move.To, null, units);
        }));
        var (move, done) = timeline.At(part);
        printed.ShowUntil(Math.Max(move, 0), done);
        var pose = timeline.PoseAt(part);
        var outline = TurtleShape.Outline(pose, size, units);
        var box = outline.GetBoundingBox(true);
        box.Union(printed.Box);
        run.Show(new Turtle(this, printed, outline, TurtleShape.Face(pose, size, units), box));
        run.Set(0, outline);
        run.Set(1, RhinoGeometry.ToPlane(pose, units));
    }

    private sealed record Turtle(TurtlePreviewComponent Owner, PrintedLines Printed, Rg.PolylineCurve Outline, Rg.Mesh Face, Rg.BoundingBox Box) : IDrawn
    {
        public void DrawWires(IGH_PreviewArgs args, bool selected)
        {
            Printed.Draw(args.Display, selected ? args.WireColour_Selected : PrintedColor, 2);
            args.Display.DrawCurve(Outline, selected ? args.WireColour_Selected : OutlineColor, 2);
        }

        public void DrawMeshes(IGH_PreviewArgs args, bool selected)
            => args.Display.DrawMeshShaded(Face, selected ? args.ShadeMaterial_Selected : Owner.Shade);
    }
}
