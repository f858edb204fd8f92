using System.Collections.Generic;
using Caterpillar.Geometry;
using Caterpillar.GH.Conversion;
using Grasshopper.Kernel;
using Grasshopper.Kernel.Types;

namespace Caterpillar.GH.Goos;

/// <summary>
/// Goo that is drawn as one thin wire in the given color; not drawn if it is very large. Its curves in document units are computed once for each
/// unit.
/// </summary>
public abstract class DrawnGoo<T> : GH_GeometricGoo<T>, IGH_PreviewData
    where T : class
{
    private IReadOnlyList<Rg.PolylineCurve>? _curves;
    private double _curveScale;

    public override bool IsValid => Value is not null;

    public override string IsValidWhyNot => IsValid ? "" : $"There is no {TypeName.ToLowerInvariant()}.";

    public override Rg.BoundingBox Boundingbox => Value is null ? Rg.BoundingBox.Empty : RhinoGeometry.ToBox(Bounds, DocumentUnits.Current);

    public Rg.BoundingBox ClippingBox => Boundingbox;

    /// <summary>Bounds of what is printed, mm.</summary>
    private protected abstract Bounds Bounds { get; }

    private protected abstract bool IsVeryLarge { get; }

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
        if (Value is null || IsVeryLarge) return;
        foreach (var curve in Curves()) args.Pipeline.DrawCurve(curve, args.Color, 1);
    }

    public void DrawViewportMeshes(GH_PreviewMeshArgs args)
    {
    }

    private protected abstract IReadOnlyList<Rg.PolylineCurve> CurvesIn(DocumentUnits units);

    private protected abstract IGH_GeometricGoo Image(Affine map);

    private protected IReadOnlyList<Rg.PolylineCurve> Curves()
    {
        var units = DocumentUnits.Current;
        if (_curves is null || _curveScale != units.ToMillimeters) _curves = CurvesIn(units);
        _curveScale = units.ToMillimeters;
        return _curves;
    }
}
