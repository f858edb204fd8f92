using Caterpillar.Toolpaths;
using Grasshopper.Kernel.Types;

namespace Caterpillar.GH.Goos;

/// <summary>The strand of a path on a wire.</summary>
public sealed class BeadGoo : GH_Goo<Bead>
{
    // A stroke without extrusion is a bead of zeros.
    private bool _isSet;

    public BeadGoo()
    {
    }

    public BeadGoo(Bead bead)
    {
        Value = bead;
        _isSet = true;
    }

    public override bool IsValid => _isSet;

    public override string IsValidWhyNot => _isSet ? "" : "There is no bead.";

    public override string TypeName => "Bead";

    public override string TypeDescription => "A strand: cross-section in mm², height in mm, speed in mm/s.";

    public override IGH_Goo Duplicate() => _isSet ? new BeadGoo(Value) : new BeadGoo();

    /// <summary>The value for script components.</summary>
    public override object ScriptVariable() => Value;

    public override bool CastFrom(object source)
    {
        var bare = Wrapped.Bare(source);
        if (bare is BeadGoo { _isSet: true } goo) bare = goo.Value;
        if (bare is not Bead bead) return false;
        Value = bead;
        _isSet = true;
        return true;
    }

    public override bool CastTo<Q>(ref Q target)
    {
        if (Value is not Q value) return false;
        target = value;
        return true;
    }

    public override string ToString() => _isSet ? $"Bead ({Value})" : "No Bead";
}
