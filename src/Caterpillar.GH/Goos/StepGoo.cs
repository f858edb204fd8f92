using Caterpillar.GH.Conversion;
using Caterpillar.Toolpaths;
using Grasshopper.Kernel.Types;

namespace Caterpillar.GH.Goos;

/// <summary>A step of a design on a wire: a print path, a travel move or an event.</summary>
public sealed class StepGoo(Step? step) : ValueGoo<Step>(step)
{
    public StepGoo()
        : this(null)
    {
    }

    public override string TypeName => "Step";

    public override string TypeDescription => "A step of a design: a print path, a travel move or an event.";

    public override IGH_Goo Duplicate() => new StepGoo(Value);

    public override bool CastFrom(object source)
    {
        switch (Wrapped.Bare(source))
        {
            case PrintPathGoo { Value: not null } goo: Value = goo.ToStep(); return true;
            case PrintPath path: Value = path; return true;
            case PrinterEvent what: Value = what; return true;
            default: return base.CastFrom(source) || FromCurve(source);
        }
    }

    public override bool CastTo<Q>(ref Q target)
    {
        if (Value is PathStep path && typeof(Q) == typeof(PrintPathGoo)) return Give(new PrintPathGoo(path), ref target);
        return base.CastTo(ref target);
    }

    protected override string Describe(Step value) => value switch
    {
        PathStep path => new PrintPathGoo(path).ToString(),
        TravelStep travel => $"Travel ({Basics.NumberFormatter.Format(travel.Points.Count)} points)",
        EventStep what => what.Event.ToString(),
        _ => "Step",
    };

    private bool FromCurve(object source)
    {
        var path = new PrintPathGoo();
        if (!path.CastFrom(source)) return false;
        Value = path.Value;
        return true;
    }

    private static bool Give<Q>(object made, ref Q target)
    {
        if (made is not Q result) return false;
        target = result;
        return true;
    }
}
