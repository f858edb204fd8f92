using System.Collections.Generic;
using Caterpillar.Basics;
using Caterpillar.GCode;
using Caterpillar.GH.Conversion;
using Caterpillar.Machines;
using Caterpillar.Toolpaths;
using Grasshopper.Kernel;
using Grasshopper.Kernel.Types;

namespace Caterpillar.GH.Goos;

/// <summary>A toolpath on a wire. Native Move, Orient and Scale work on it; its preview is one thin wire along what is printed.</summary>
public sealed class ToolpathGoo : GH_GeometricGoo<Toolpath>, IGH_PreviewData
{
    private ToolpathTotals? _totals;
    private List<Rg.PolylineCurve>? _curves;
    private double _curveScale;

    public ToolpathGoo()
    {
    }

    public ToolpathGoo(Toolpath? toolpath)
    {
        Value = toolpath!;
    }

    /// <summary>A toolpath that was planned for a printer, a material and settings.</summary>
    public ToolpathGoo(Toolpath? toolpath, PrintSetup? setup)
        : this(toolpath)
    {
        Setup = setup;
    }

    /// <summary>A toolpath that was decoded from a file.</summary>
    public ToolpathGoo(Decoding decoding)
        : this(decoding?.Toolpath)
    {
        Decoding = decoding;
    }

    private ToolpathGoo(ToolpathGoo other, Toolpath? toolpath)
        : this(toolpath, other.Setup)
    {
        Decoding = other.Decoding;
    }

    /// <summary>What it was planned for, where that is known.</summary>
    public PrintSetup? Setup { get; }

    /// <summary>The file that it was decoded from, where it was: written again, lines that no edit touches stay as they are.</summary>
    public Decoding? Decoding { get; }

    public override bool IsValid => Value is not null;

    public override string IsValidWhyNot => IsValid ? "" : "There is no toolpath.";

    public override string TypeName => "Toolpath";

    public override string TypeDescription => "What the printer does, move by move: positions in mm, speeds in mm/s.";

    public override Rg.BoundingBox Boundingbox => Value is null ? Rg.BoundingBox.Empty : RhinoGeometry.ToBox(Totals.PrintBounds, DocumentUnits.Current);

    public Rg.BoundingBox ClippingBox => Boundingbox;

    private ToolpathTotals Totals => _totals ??= ToolpathTotals.Of(Value);

    public override IGH_GeometricGoo DuplicateGeometry() => new ToolpathGoo(this, Value) { _totals = _totals };

    /// <summary>An edit of it.</summary>
    public ToolpathGoo With(Toolpath edited) => new(this, edited);

    public override object? ScriptVariable() => Value;

    public override Rg.BoundingBox GetBoundingBox(Rg.Transform xform)
    {
        var box = Boundingbox;
        box.Transform(xform);
        return box;
    }

    public override IGH_GeometricGoo? Transform(Rg.Transform xform)
        => Value is not null && RhinoGeometry.ToAffine(xform, DocumentUnits.Current) is { } map ? With(Value.Transformed(map)) : null;

    /// <summary>A toolpath can't be bent as a whole: bend its print paths and plan again.</summary>
    public override IGH_GeometricGoo? Morph(Rg.SpaceMorph xmorph) => null;

    public override bool CastFrom(object source)
    {
        if (source is ToolpathGoo goo) source = goo.Value;
        if (source is not Toolpath toolpath) return false;
        Value = toolpath;
        return true;
    }

    // By reference as in GH_Goo; GH_GeometricGoo shows the same method with an out parameter, which is the same to the runtime.
    public override bool CastTo<Q>(ref Q target)
    {
        if (Value is not Q value) return false;
        target = value;
        return true;
    }

    public void DrawViewportWires(GH_PreviewWireArgs args)
    {
        if (Value is null || Value.Count > PreviewLimits.Moves) return;
        var units = DocumentUnits.Current;
        if (_curves is null || _curveScale != units.ToMillimetres) _curves = RhinoGeometry.ToCurves(Value, units);
        _curveScale = units.ToMillimetres;
        foreach (var curve in _curves) args.Pipeline.DrawCurve(curve, args.Color, 1);
    }

    public void DrawViewportMeshes(GH_PreviewMeshArgs args)
    {
    }

    public override string ToString() => Value is null
        ? "No Toolpath"
        : $"Toolpath ({NumberFormatter.Format(Value.Count)} moves, {NumberFormatter.Format(Value.Layers.Count)} layers, "
            + $"{NumberFormatter.Format(Totals.PrintLength / 1000, 2)} m printed)";
}
