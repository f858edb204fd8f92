namespace Caterpillar.GH.Goos;

/// <summary>A selection of moves on a wire.</summary>
public sealed class MoveFilterGoo : ValueGoo<MoveFilter>
{
    public override string TypeName => "Move Filter";

    public override string TypeDescription => "Selects moves of a toolpath by role, layer, object, tool or box.";

    protected override string Describe(MoveFilter value)
    {
        var parts = new List<string>();
        if (value.Roles is { } roles) parts.Add(string.Join(", ", roles));
        if (value.FirstLayer is { } first) parts.Add($"from layer {NumberFormatter.Format(first)}");
        if (value.LastLayer is { } last) parts.Add($"to layer {NumberFormatter.Format(last)}");
        if (value.Objects is { } objects) parts.Add(string.Join(", ", objects));
        if (value.Tool is { } tool) parts.Add($"tool {NumberFormatter.Format(tool)}");
        if (value.Box is not null) parts.Add("in a box");
        return $"Move Filter ({(parts.Count == 0 ? "all moves" : string.Join("; ", parts))})";
    }
}
