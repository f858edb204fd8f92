namespace Caterpillar.Machines;

/// <summary>A list of mapped axes as texts.</summary>
internal sealed class MappingFormat() : TextsFormat<AxisMapping>("a list of texts such as \"X=A*2.86\"")
{
    public override string Range => "a list of AXIS=WORD*SCALE";

    protected override string Pattern => "^[XYZ]=[ABCXYZ]\\*[-0-9.]+(@[-0-9.]+)?$";

    protected override AxisMapping? Item(string text) => AxisMapping.Parse(text);

    public override string? Problem(ValueList<AxisMapping> value)
        => value.Select(m => m.From).Distinct().Count() == value.Count ? null : "maps a coordinate twice";
}
