using System;
using System.Collections.Generic;
using System.Threading;
using Caterpillar.Geometry;
using Caterpillar.Toolpaths;

namespace Caterpillar.Shaping;

/// <summary>Divides the segments of a path: before a deformation until its image is smooth, before a modulation until it resolves the field.</summary>
internal static class PathDivision
{
    private const int MaxDepth = 14;

    // mm; arcs have no straight ends to keep.
    private const double ArcTolerance = 0.01;

    // The image of a segment is tested at these places; the odd spacing keeps periodic maps from hiding between them.
    private static readonly double[] Tests = [0.19, 0.37, 0.5, 0.68, 0.83];

    /// <summary>All vertices (the first again at the end of a closed path) and a bead for each segment.</summary>
    public static (Vec3[] Points, Bead[] Beads) Divide(PrintPath path, double tolerance, Deformation deformation, CancellationToken cancel)
    {
        if (!(tolerance > 0))
        {
            var straight = Straight(path, 0, cancel);
            return (straight.Closed ? [.. straight.Points, path.Start] : straight.Points, straight.Beads);
        }
        var points = new List<Vec3> { path.Start };
        var beads = new List<Bead>();
        for (var i = 0; i < path.SegmentCount; i++)
        {
            if ((i & 0xFFF) == 0) cancel.ThrowIfCancellationRequested();
            Split(new Piece(path, i), 0, 1, tolerance, deformation, 0, points);
            while (beads.Count < points.Count - 1) beads.Add(path.BeadOf(i));
        }
        return (points.ToArray(), beads.ToArray());
    }

    /// <summary>Straight segments of at most <paramref name="maximum"/> mm in equal parts (0 leaves straight segments whole); a closed path stays closed.</summary>
    public static (Vec3[] Points, Bead[] Beads, bool Closed) Straight(PrintPath path, double maximum, CancellationToken cancel)
    {
        var points = new List<Vec3> { path.Start };
        var beads = new List<Bead>();
        for (var i = 0; i < path.SegmentCount; i++)
        {
            if ((i & 0xFFF) == 0) cancel.ThrowIfCancellationRequested();
            var piece = new Piece(path, i);
            var parts = path.ArcOf(i)?.ChordCount(path.Points[i], ArcTolerance) ?? 1.0;
            if (maximum > 0) parts = Math.Max(parts, Math.Ceiling(path.LengthOf(i) / maximum - 1e-9));
            parts = Math.Min(parts, 10_000_000);
            for (var k = 1; k <= parts; k++)
            {
                points.Add(k == parts ? piece.End : piece.At(k / parts));
                beads.Add(path.BeadOf(i));
            }
        }
        if (path.IsClosed) points.RemoveAt(points.Count - 1);
        return (points.ToArray(), beads.ToArray(), path.IsClosed);
    }

    private static void Split(Piece piece, double from, double to, double tolerance, Deformation deformation, int depth, List<Vec3> points)
    {
        if (depth < MaxDepth && !IsSmooth(piece, from, to, tolerance, deformation))
        {
            var middle = (from + to) / 2;
            Split(piece, from, middle, tolerance, deformation, depth + 1, points);
            Split(piece, middle, to, tolerance, deformation, depth + 1, points);
            return;
        }
        points.Add(to == 1 ? piece.End : piece.At(to));
    }

    private static bool IsSmooth(Piece piece, double from, double to, double tolerance, Deformation deformation)
    {
        var samples = new Vec3[Tests.Length + 2];
        samples[0] = piece.At(from);
        for (var i = 0; i < Tests.Length; i++) samples[i + 1] = piece.At(from + (to - from) * Tests[i]);
        samples[samples.Length - 1] = piece.At(to);
        var mapped = deformation.Map(samples);
        Vec3 a = mapped[0], b = mapped[mapped.Length - 1];
        for (var i = 1; i < mapped.Length - 1; i++)
        {
            // Points that are not finite are reported where the path is mapped, not here.
            if (Distance(mapped[i], a, b) > tolerance) return false;
        }
        return true;
    }

    private static double Distance(Vec3 p, Vec3 a, Vec3 b)
    {
        var d = b - a;
        var length = d.LengthSquared;
        var t = length > 0 ? Math.Max(0, Math.Min(1, Vec3.Dot(p - a, d) / length)) : 0;
        return p.DistanceTo(a + d * t);
    }

    private readonly struct Piece(PrintPath path, int segment)
    {
        private readonly Vec3 _start = path.Points[segment];
        private readonly Arc? _arc = path.ArcOf(segment);

        public Vec3 End { get; } = path.EndOf(segment);

        public Vec3 At(double t) => _arc is { } arc ? arc.PointAt(_start, End, t) : Vec3.Lerp(_start, End, t);
    }
}
