namespace Caterpillar.GH.Components.GCode;

/// <summary>Changes speed, flow and position of some moves.</summary>
public sealed class EditToolpathComponent() : CaterpillarComponent(
    "Edit Toolpath", "EditT", "Changes speed, flow and position of moves, all or those that Move Filter selects.", Panel.GCode, GH_Exposure.tertiary)
{
    public override Guid ComponentGuid => new("6d772550-a4bb-485d-addc-16452e9b9ef2");

    private protected override void Inputs(InputPorts ports)
    {
        ports.Toolpath();
        ports.Filter();
        ports.Number("Speed Factor", "S", "Speed factor of the selected moves.", 1);
        ports.Number("Flow Factor", "Fl", "Flow ratio of the selected moves.", 1);
        ports.Add(new Param_Transform(), "Transform", "X",
            "Transformation of the selected extrusions. Start and end G-code keep their position.", optional: true);
    }

    private protected override void Outputs(OutputPorts ports) => ports.Add(new ToolpathParam(), "Toolpath", "T", "Toolpath with the selected moves changed.");

    private protected override void Solve(Run run)
    {
        var goo = run.Get<ToolpathGoo>(0);
        var filter = run.Filter();
        var (speed, flow) = (run.Positive(2), run.NotNegative(3));
        var map = run.MaybeValue<Rg.Transform>(4) is { } transform
            ? RhinoGeometry.ToAffine(transform, run.Units) ?? throw new InputProblem("Transform must be affine: move, rotate, scale or shear.")
            : (Affine?)null;
        var edited = run.Work("Editing", [goo.Value, speed, flow, map, filter],
            (_, cancel) => Edit(goo.Value, filter, speed, flow, map, cancel));
        run.Set(0, goo.With(edited));
    }

    private static Toolpath Edit(Toolpath edited, MoveFilter filter, double speed, double flow, Affine? map, CancellationToken cancel)
    {
        if (speed != 1) edited = edited.ScaleSpeed(filter, speed, cancel);
        if (flow != 1) edited = edited.ScaleFlow(filter, flow, cancel);
        // Start and end code, which belong to no layer, stay.
        return map is { } moved ? edited.Transform(filter.InLayersOf(edited), moved, cancel: cancel) : edited;
    }
}
