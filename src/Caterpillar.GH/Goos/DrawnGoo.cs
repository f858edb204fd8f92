using Rhino.DocObjects;

namespace Caterpillar.GH.Goos;

/// <summary>
/// Goo that is drawn as one thin wire in the given color, or as some of its lines if it is very large. They are computed once for each unit.
/// Parameters of the plug-in draw all of theirs in one call instead. Baked as several objects, it has the id of the first.
/// </summary>
public abstract class DrawnGoo<T> : GH_GeometricGoo<T>, IGH_PreviewData, IGH_BakeAwareData, IBakes, IWires
    where T : class
{
    private WireSet? _wires;

    public override bool IsValid => Value is not null;

    public override string IsValidWhyNot => IsValid ? "" : $"No {TypeName.ToLowerInvariant()}.";

    public override Rg.BoundingBox Boundingbox => Value is null ? Rg.BoundingBox.Empty : RhinoGeometry.ToBox(Bounds, DocumentUnits.Current);

    public Rg.BoundingBox ClippingBox => Boundingbox;

    Bounds IWires.Bounds => Value is null ? Bounds.Empty : Bounds;

    int IWires.SegmentCount => Value is null ? 0 : SegmentCount;

    int IWires.LayerCount => Value is null ? 0 : LayerCount;

    /// <summary>Bounds of the extrusions, mm.</summary>
    private protected abstract Bounds Bounds { get; }

    /// <summary>Number of segments or moves, arcs counted as one.</summary>
    private protected abstract int SegmentCount { get; }

    /// <summary>Number of layers up to the last one. 0 without layers.</summary>
    private protected abstract int LayerCount { get; }

    public override object? ScriptVariable() => Value;

    public override bool CastFrom(object source)
    {
        switch (Wrapped.Bare(source))
        {
            case DrawnGoo<T> goo: Value = goo.Value; break;
            case T value: Value = value; break;
            case var other: return CastFromOther(other);
        }
        return Value is not null;
    }

    // By reference as in GH_Goo. GH_GeometricGoo shows the same method with an out parameter, which is the same to the runtime.
    public override bool CastTo<Q>(ref Q target)
    {
        if (Value is null) return false;
        object? made = typeof(Q).IsAssignableFrom(typeof(T)) ? Value : Native(typeof(Q), DocumentUnits.Current);
        if (made is not Q result) return false;
        target = result;
        return true;
    }

    public override Rg.BoundingBox GetBoundingBox(Rg.Transform xform)
    {
        var box = Boundingbox;
        box.Transform(xform);
        return box;
    }

    public override IGH_GeometricGoo? Transform(Rg.Transform xform)
        => Value is not null && RhinoGeometry.ToAffine(xform, DocumentUnits.Current) is { } map ? Image(map) : null;

    public void DrawViewportWires(GH_PreviewWireArgs args)
    {
        var units = DocumentUnits.Current;
        if (_wires is null || !_wires.Fits(units)) _wires = new WireSet([this], units);
        _wires.Draw(args.Pipeline, args.Color);
    }

    public void DrawViewportMeshes(GH_PreviewMeshArgs args)
    {
    }

    public bool BakeGeometry(RhinoDoc doc, ObjectAttributes att, out Guid obj_guid)
    {
        var ids = doc is null ? [] : new Baker(doc, att).Add([this]);
        obj_guid = ids.Count > 0 ? ids[0] : Guid.Empty;
        return ids.Count > 0;
    }

    IEnumerable<BakedPart> IBakes.ToParts(DocumentUnits units) => Value is null ? [] : ToParts(units);

    void IWires.AddTo(List<Rg.Line> lines, DocumentUnits units, Thinning thinning, int first)
    {
        if (Value is not null) AddWires(lines, units, thinning, first);
    }

    /// <summary>Casts any source that is neither such a value nor goo with one.</summary>
    private protected virtual bool CastFromOther(object? source) => false;

    /// <summary>The value as geometry of Rhino or Grasshopper. Null if it has none of that type.</summary>
    private protected abstract object? Native(Type wanted, DocumentUnits units);

    private protected abstract IEnumerable<BakedPart> ToParts(DocumentUnits units);

    private protected abstract void AddWires(List<Rg.Line> lines, DocumentUnits units, Thinning thinning, int first);

    private protected abstract IGH_GeometricGoo Image(Affine map);
}
