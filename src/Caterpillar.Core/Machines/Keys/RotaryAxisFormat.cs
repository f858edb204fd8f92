namespace Caterpillar.Machines;

/// <summary>A list of rotary axes as texts.</summary>
internal sealed class RotaryAxisFormat() : TextsFormat<RotaryAxis>("a list of texts such as \"B head y at 0 0 42 from -110 to 110\"")
{
    public override string Range => "a list of WORD head/work x/y/z [at X Y Z] [from MIN] [to MAX] [speed S] [acceleration A]";

    protected override string Pattern => "^[ABC] (head|work) -?[xyz]( at( -?[0-9.]+){3})?( (from|to|speed|acceleration) -?[0-9.]+)*$";

    protected override RotaryAxis? Item(string text) => RotaryAxis.Parse(text);

    public override string? Problem(ValueList<RotaryAxis> value) => Kinematics.Problem(value);
}
