using System.Collections.Generic;
using Caterpillar.Geometry;
using Caterpillar.GH.Conversion;
using Grasshopper.Kernel;
using Grasshopper.Kernel.Types;

namespace Caterpillar.GH.Goos;

/// <summary>
/// Goo that is drawn as one thin wire in the given color; not drawn if it is very large. Its lines in document units are computed once for each unit.
/// Parameters of the plug-in draw all of theirs in one call instead.
/// </summary>
public abstract class DrawnGoo<T> : GH_GeometricGoo<T>, IGH_PreviewData, IWires
    where T : class
{
    private WireSet? _wires;

    public override bool IsValid => Value is not null;

    public override string IsValidWhyNot => IsValid ? "" : $"There is no {TypeName.ToLowerInvariant()}.";

    public override Rg.BoundingBox Boundingbox => Value is null ? Rg.BoundingBox.Empty : RhinoGeometry.ToBox(Bounds, DocumentUnits.Current);

    public Rg.BoundingBox ClippingBox => Boundingbox;

    Bounds IWires.Bounds => Value is null ? Bounds.Empty : Bounds;

    int IWires.SegmentCount => Value is null ? 0 : SegmentCount;

    /// <summary>Bounds of what is printed, mm.</summary>
    private protected abstract Bounds Bounds { get; }

    /// <summary>Number of segments or moves, arcs counted as one.</summary>
    private protected abstract int SegmentCount { get; }

    public override object? ScriptVariable() => Value;

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

    void IWires.AddTo(List<Rg.Line> lines, DocumentUnits units)
    {
        if (Value is not null) AddWires(lines, units);
    }

    private protected abstract void AddWires(List<Rg.Line> lines, DocumentUnits units);

    private protected abstract IGH_GeometricGoo Image(Affine map);
}
