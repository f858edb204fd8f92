using System;
using System.Collections.Generic;
using Caterpillar.Geometry;
using Caterpillar.GH.Conversion;
using Caterpillar.Toolpaths;

namespace Caterpillar.GH.Bake;

/// <summary>A run of printing moves without a gap, in one layer and with one role: moves from First to before End.</summary>
internal readonly record struct ToolpathStrand(int First, int End);

/// <summary>The strands of a toolpath.</summary>
internal static class ToolpathStrands
{
    public static IEnumerable<ToolpathStrand> Of(Toolpath toolpath)
    {
        var first = -1;
        for (var i = 0; i < toolpath.Count; i++)
        {
            var move = toolpath[i];
            var prints = move.Kind == MoveKind.Print && move.Length > 0;
            // A pause of the extruder between two strands does not part them, a travel does.
            if (!prints && (move.Length == 0 || first < 0)) continue;
            if (first >= 0 && (!prints || move.Role != toolpath[first].Role || move.Layer != toolpath[first].Layer))
            {
                yield return new ToolpathStrand(first, i);
                first = -1;
            }
            if (prints && first < 0) first = i;
        }
        if (first >= 0) yield return new ToolpathStrand(first, toolpath.Count);
    }

    /// <summary>A strand as a polyline, or with its arcs as arcs; null if it has no length.</summary>
    public static Rg.Curve? ToCurve(Toolpath toolpath, ToolpathStrand strand, DocumentUnits units)
    {
        var lines = new List<Rg.Line>();
        var arcs = false;
        for (var i = strand.First; i < strand.End; i++) arcs |= toolpath[i].Arc is not null;
        if (!arcs)
        {
            for (var i = strand.First; i < strand.End; i++) Add(lines, toolpath[i], units);
            return PolylineMaker.Of(lines);
        }
        var joined = new Rg.PolyCurve();
        void Flush()
        {
            if (PolylineMaker.Of(lines) is { } part) joined.Append(part);
            lines.Clear();
        }
        for (var i = strand.First; i < strand.End; i++)
        {
            var move = toolpath[i];
            // Rhino has no helical arcs: those stay chords.
            if (move is { Kind: MoveKind.Print, Arc: { Plane: ArcPlane.XY } arc } && move.Start.Z == move.End.Z && Math.Abs(arc.Sweep) <= 360)
            {
                Flush();
                joined.Append(ToArc(move.Start, arc, units));
            }
            else
            {
                Add(lines, move, units);
            }
        }
        Flush();
        return joined;
    }

    // Clockwise arcs turn about an axis that points down.
    private static Rg.ArcCurve ToArc(Vec3 start, Arc arc, DocumentUnits units)
    {
        var outward = start - arc.Center.WithZ(start.Z);
        var side = new Rg.Vector3d(-outward.Y, outward.X, 0) * (arc.Sweep < 0 ? -1 : 1);
        var plane = new Rg.Plane(RhinoGeometry.ToPoint(arc.Center.WithZ(start.Z), units), new Rg.Vector3d(outward.X, outward.Y, 0), side);
        return new Rg.ArcCurve(new Rg.Arc(plane, arc.Radius(start) * units.FromMillimeters, Basics.Angle.ToRadians(Math.Abs(arc.Sweep))));
    }

    private static void Add(List<Rg.Line> lines, in Move move, DocumentUnits units)
    {
        if (move.Kind == MoveKind.Print) RhinoGeometry.AddLines(lines, move.Start, move.End, move.Arc, units);
    }
}
