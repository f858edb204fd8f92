using System;
using Caterpillar.Geometry;
using Caterpillar.Toolpaths;

namespace Caterpillar.Slicing;

/// <summary>The course of one bead of a wall, or of a single strand, at Z 0.</summary>
/// <param name="Points">mm; a closed path does not repeat its first point.</param>
/// <param name="Widths">Width at each point, mm; straight in between.</param>
/// <param name="Closed">Whether it goes back to its first point.</param>
/// <param name="Index">Number of the wall from the outline, 0 for the outer one.</param>
/// <param name="IsStrand">Whether it fills a place too thin for a wall on each side.</param>
internal sealed record WallPath(Vec3[] Points, double[] Widths, bool Closed, int Index, bool IsStrand)
{
    public int SegmentCount => Closed ? Points.Length : Points.Length - 1;

    /// <summary>Volume in mm³.</summary>
    public double Volume(WallRules rules)
    {
        var sum = 0.0;
        for (var i = 0; i < SegmentCount; i++) sum += SegmentArea(i, rules) * (Points[i + 1 == Points.Length ? 0 : i + 1] - Points[i]).LengthXY;
        return sum;
    }

    /// <summary>The beads of the segments: one for all where the width is the same everywhere, else one for each.</summary>
    public Bead[] Beads(WallRules rules)
    {
        var even = true;
        foreach (var width in Widths) even &= Math.Abs(width - Widths[0]) < 1e-9;
        if (even) return [new Bead(rules.Area(Widths[0]), rules.Thickness)];
        var beads = new Bead[SegmentCount];
        for (var i = 0; i < beads.Length; i++) beads[i] = new Bead(SegmentArea(i, rules), rules.Thickness);
        return beads;
    }

    private double SegmentArea(int i, WallRules rules) => (rules.Area(Widths[i]) + rules.Area(Widths[i + 1 == Widths.Length ? 0 : i + 1])) / 2;
}
