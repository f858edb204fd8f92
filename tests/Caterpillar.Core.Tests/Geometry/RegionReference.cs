using System;
using System.Collections.Generic;
using System.Linq;
using Caterpillar.Basics;
using Caterpillar.Geometry;
using NetTopologySuite.Geometries;
using NUnit.Framework;

namespace Caterpillar.Tests.Geometry;

/// <summary>Independent truths for regions: brute-force validity, and the same areas in NetTopologySuite.</summary>
internal static class RegionReference
{
    private static readonly GeometryFactory Factory = new();

    /// <summary>A polygon on a small integer grid of given step (mm), with all the degeneracies that brings.</summary>
    public static Polyline Random(Random random, int points, int size, double step = 1)
        => new(Enumerable.Range(0, points).Select(_ => new Vec3(random.Next(size) * step, random.Next(size) * step)), closed: true);

    /// <summary>A star-shaped polygon without crossings.</summary>
    public static Polyline Star(Random random, int points, double x, double y, double min, double max)
    {
        var turn = random.NextDouble() * 360;
        return new Polyline(Enumerable.Range(0, points).Select(i =>
        {
            var (sin, cos) = Angle.SinCos(turn + 360.0 * i / points);
            var r = min + (max - min) * random.NextDouble();
            return new Vec3(x + r * cos, y + r * sin);
        }), closed: true);
    }

    public static NetTopologySuite.Geometries.Geometry ToNts(Region region)
    {
        var polygons = region.Islands.Select(island =>
        {
            var rings = island.Contours.Select(c => Factory.CreateLinearRing(c.Points.Append(c[0]).Select(p => new Coordinate(p.X, p.Y)).ToArray())).ToArray();
            return Factory.CreatePolygon(rings[0], rings.Skip(1).ToArray());
        }).ToArray();
        return Factory.CreateMultiPolygon(polygons);
    }

    /// <summary>Even-odd area of one contour by NetTopologySuite's polygonizer: the arrangement's faces whose inner point has an odd crossing number.</summary>
    public static double EvenOddArea(Polyline contour, Func<int, bool> rule)
    {
        var line = Factory.CreateLineString(contour.Points.Append(contour[0]).Select(p => new Coordinate(p.X, p.Y)).ToArray());
        var noded = NetTopologySuite.Operation.OverlayNG.OverlayNGRobust.Union(line);
        var polygonizer = new NetTopologySuite.Operation.Polygonize.Polygonizer();
        polygonizer.Add(noded);
        return polygonizer.GetPolygons().Where(face => rule(Winding(contour, face.InteriorPoint.Coordinate))).Sum(face => face.Area);
    }

    public static int Winding(Polyline contour, Coordinate p)
    {
        var winding = 0;
        for (var i = 0; i < contour.Count; i++)
        {
            Vec3 a = contour[i], b = contour[i + 1 == contour.Count ? 0 : i + 1];
            if (a.Y <= p.Y == b.Y <= p.Y) continue;
            var side = (b.X - a.X) * (p.Y - a.Y) - (b.Y - a.Y) * (p.X - a.X);
            if (a.Y <= p.Y && side > 0) winding++;
            if (a.Y > p.Y && side < 0) winding--;
        }
        return winding;
    }

    /// <summary>
    /// An offset without an offset curve: the region and, added or taken away, a rectangle at every edge and the join at every convex corner, each a
    /// polygon of its own.
    /// </summary>
    public static Region OffsetBySweeping(Region region, double d, JoinStyle join, double miterLimit)
    {
        var parts = new List<Region>();
        foreach (var contour in region.Contours)
        {
            var n = contour.Count;
            Vec3 Normal(int i)
            {
                var e = (contour[(i + 1) % n] - contour[i % n]).Unit();
                return new Vec3(e.Y, -e.X);
            }
            for (var i = 0; i < n; i++)
            {
                var v = contour[i];
                var (m, w) = (Normal(i + n - 1), Normal(i));
                parts.Add(Region.From(new Polyline(new[] { v, contour[(i + 1) % n], contour[(i + 1) % n] + w * d, v + w * d }, true)));
                if (Vec3.Cross(m, w).Z * d > 0) parts.Add(Region.From(new Polyline(Join(v, m, w, d, join, miterLimit), true)));
            }
        }
        var swept = Region.Union(parts);
        return d > 0 ? region.Union(swept) : region.Subtract(swept);
    }

    private static IEnumerable<Vec3> Join(Vec3 v, Vec3 m, Vec3 w, double d, JoinStyle join, double miterLimit)
    {
        var dot = Vec3.Dot(m, w);
        yield return v;
        yield return v + m * d;
        var bisector = (m + w).Unit();
        var half = Math.Sqrt((1 + dot) / 2);
        if (join == JoinStyle.Round)
        {
            var turn = Angle.Atan2(Vec3.Cross(m, w).Z, dot);
            for (var k = 1; k < 60; k++)
            {
                var (sin, cos) = Angle.SinCos(turn * k / 60);
                yield return v + new Vec3(m.X * cos - m.Y * sin, m.Y * cos + m.X * sin) * d;
            }
        }
        else if (join == JoinStyle.Miter && 1 / half <= miterLimit)
        {
            yield return v + bisector * (d / half);
        }
        else
        {
            // The line across the bisector at distance d, cut by the moved edges: tan of a quarter of the turn to each side.
            var side = Math.Abs(d) * Angle.Sin(Angle.Atan2(Math.Sqrt((1 - dot) / 2), half) / 2) / Angle.Cos(Angle.Atan2(Math.Sqrt((1 - dot) / 2), half) / 2);
            yield return v + m * d + new Vec3(-m.Y, m.X) * side;
            yield return v + w * d - new Vec3(-w.Y, w.X) * side;
        }
        yield return v + w * d;
    }

    /// <summary>Holds if rings are simple, do not cross, have the inside on their left and alternate in depth. Brute force, exact.</summary>
    public static void AssertValid(Region region)
    {
        var segments = new List<Segment>();
        foreach (var path in region.Paths)
        {
            Assert.That(path, Has.Length.GreaterThanOrEqualTo(3));
            Assert.That(path.Distinct().Count(), Is.EqualTo(path.Length), "a ring visits a vertex twice");
            for (var i = 0; i < path.Length; i++) segments.Add(new Segment(path[i], path[(i + 1) % path.Length]));
        }
        for (var i = 0; i < segments.Count; i++)
        {
            for (var j = i + 1; j < segments.Count; j++)
            {
                if (Conflict(segments[i], segments[j])) Assert.Fail($"crossing or overlap: {segments[i].A}{segments[i].B} with {segments[j].A}{segments[j].B}");
            }
        }
        foreach (var path in region.Paths)
        {
            // Just left of the middle of an edge that is not horizontal the winding number is 1.
            var e = 0;
            while (path[e].Y == path[(e + 1) % path.Length].Y) e++;
            GridPoint from = path[e], to = path[(e + 1) % path.Length];
            long x = (long)from.X + to.X, y = (long)from.Y + to.Y;
            var winding = from.Y < to.Y ? 1 : 0;
            foreach (var s in segments)
            {
                if ((s.A == from && s.B == to) || 2L * s.Ay <= y == 2L * s.By <= y) continue;
                var side = ((long)s.Bx - s.Ax) * (y - 2L * s.Ay) - ((long)s.By - s.Ay) * (x - 2L * s.Ax);
                if (s.Ay < s.By ? side > 0 : side < 0) winding += s.Ay < s.By ? 1 : -1;
            }
            Assert.That(winding, Is.EqualTo(1), "inside on the left");
        }
    }

    private static bool Conflict(Segment s, Segment t)
    {
        if (Math.Max(s.Ax, s.Bx) < Math.Min(t.Ax, t.Bx) || Math.Max(t.Ax, t.Bx) < Math.Min(s.Ax, s.Bx)) return false;
        if (Math.Max(s.Ay, s.By) < Math.Min(t.Ay, t.By) || Math.Max(t.Ay, t.By) < Math.Min(s.Ay, s.By)) return false;
        int a = Math.Sign(t.Side(s.Ax, s.Ay)), b = Math.Sign(t.Side(s.Bx, s.By)), c = Math.Sign(s.Side(t.Ax, t.Ay)), d = Math.Sign(s.Side(t.Bx, t.By));
        if (a * b > 0 || c * d > 0) return false;
        if (a == 0 && b == 0)
        {
            // Collinear: only an end point in common is allowed.
            var shared = s.A == t.A || s.A == t.B ? s.A : s.B;
            if (shared != t.A && shared != t.B) return true;
            var u = shared == s.A ? s.B : s.A;
            var v = shared == t.A ? t.B : t.A;
            return ((long)u.X - shared.X) * ((long)v.X - shared.X) + ((long)u.Y - shared.Y) * ((long)v.Y - shared.Y) > 0;
        }
        return !(s.A == t.A || s.A == t.B || s.B == t.A || s.B == t.B);
    }
}
