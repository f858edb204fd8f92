namespace Caterpillar.GH.Components.GCode;

/// <summary>Selects moves.</summary>
public sealed class MoveFilterComponent() : CaterpillarComponent(
    "Move Filter", "Filter", "Selects moves by role, layer, object, tool or box, for Filter Toolpath, Edit Toolpath and Deform Toolpath. A move must meet "
        + "all conditions.", Panel.GCode, GH_Exposure.tertiary)
{
    public override Guid ComponentGuid => new("58d0e7b2-3c41-4f9a-b6d5-1a7c8e2f0b42");

    private protected override void Inputs(InputPorts ports)
    {
        ports.Choices<Role>("Roles", "R", "Roles of the moves to select, such as Outer Wall or Infill. Default: all.");
        ports.Integer("First Layer", "F", "First layer, by its number in the file or from 0. Default: no limit.", optional: true);
        ports.Integer("Last Layer", "L", "Last layer, by its number in the file or from 0. Default: no limit.", optional: true);
        ports.Text("Objects", "O", "Names of the objects to select, as in the file. Default: all.", access: GH_ParamAccess.list, optional: true);
        ports.Integer("Tool", "T", "Number of the tool, from 0. Default: all.", optional: true);
        ports.Geometry("Box", "B", "Geometry whose bounding box contains the end points of the moves to select. Default: no limit.", optional: true);
    }

    private protected override void Outputs(OutputPorts ports) => ports.Add(new MoveFilterParam(), "Filter", "F", "Selection, for Edit Toolpath and others.");

    private protected override void Solve(Run run)
    {
        var (roles, objects) = (run.Choices<Role>(0), run.List<string>(3));
        var (first, last, tool) = (run.MaybeValue<int>(1), run.MaybeValue<int>(2), run.MaybeValue<int>(4));
        var box = run.Maybe<IGH_GeometricGoo>(5)?.Boundingbox;
        if (box is { IsValid: false }) throw new InputProblem("Box is empty: connect geometry with a valid bounding box.");
        var bounds = box is { } given ? RhinoGeometry.ToBounds(given, run.Units) : (Geometry.Bounds?)null;
        // The same filter for the same values: edits with it are not made again.
        object?[] key = [string.Join(",", roles ?? []), first, last, string.Join("\n", objects), tool, bounds];
        run.Set(0, new MoveFilterGoo { Value = run.Cached(key, () => new MoveFilter
        {
            Roles = roles, FirstLayer = first, LastLayer = last, Objects = objects.Count > 0 ? objects : null, Tool = tool, Box = bounds,
        }) });
    }
}
