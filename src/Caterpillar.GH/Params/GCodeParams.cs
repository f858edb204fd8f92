namespace Caterpillar.GH.Params;

/// <summary>G-code files. Text is G-code.</summary>
public sealed class GCodeParam() : VolatileParam<GCodeGoo>("G-code", "GCode", "Contains G-code files. Text is read as G-code.", Panel.GCode)
{
    public override Guid ComponentGuid => new("c626418d-8e36-4127-935e-c83c2c852506");
}

/// <summary>Steps of a design: print paths, travel moves and events.</summary>
public sealed class StepParam() : VolatileParam<StepGoo>("Step", "Step", "Contains steps of a design: print paths, travel moves and events.", Panel.Path)
{
    public override Guid ComponentGuid => new("9338155d-65ee-4cc2-939c-d876fc935887");

    // Most steps are print paths, and many.
    protected override StepGoo PreferredCast(object data)
        => data is PrintPathGoo { Value: not null } path ? new StepGoo(path) : base.PreferredCast(data);
}

/// <summary>Selections of moves.</summary>
public sealed class MoveFilterParam() : VolatileParam<MoveFilterGoo>("Move Filter", "Filter", "Contains selections of moves of a toolpath.", Panel.GCode)
{
    public override Guid ComponentGuid => new("91f5c3a8-2d7e-4b60-a8c4-6e1b9d0f3c41");
}

/// <summary>Fields of layers. Surfaces and formulas are fields as well.</summary>
public sealed class LayerFieldParam() : VolatileParam<LayerFieldGoo>(
    "Layer Field", "Field", "Contains fields whose level sets are layers. Layers copy a surface upward. Text is read as a formula.", Panel.Slice)
{
    public override Guid ComponentGuid => new("0b9f3f5e-6d0c-4a35-8f3e-2c7d9c1b6a57");

    protected override LayerFieldGoo PreferredCast(object data) => TextProblem.Read(this, InstantiateT(), data)!;

    protected override void OnVolatileDataCollected() => TextProblem.Clean(m_data, goo => !goo.IsValid);
}
