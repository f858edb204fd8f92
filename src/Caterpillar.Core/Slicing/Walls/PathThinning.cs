using System;
using System.Collections.Generic;
using Caterpillar.Geometry;

namespace Caterpillar.Slicing;

/// <summary>Leaves points away whose place and width are within tolerances of the straight line between their neighbors (Douglas and Peucker 1973).</summary>
internal static class PathThinning
{
    /// <summary>The points to keep.</summary>
    public static (Vec3[] Points, double[] Widths) Thin(
        IReadOnlyList<Vec3> points, IReadOnlyList<double> widths, bool closed, double tolerance, double widthTolerance)
    {
        var n = points.Count;
        // A closed path is cut open where it begins and ends at the same point.
        var count = closed ? n + 1 : n;
        var keep = new bool[count];
        keep[0] = keep[count - 1] = true;
        var work = new Stack<(int From, int To)>();
        work.Push((0, count - 1));
        while (work.Count > 0)
        {
            var (from, to) = work.Pop();
            Vec3 a = points[from], b = points[to % n], d = b - a;
            double wa = widths[from], wb = widths[to % n];
            var square = d.X * d.X + d.Y * d.Y;
            var worst = 1.0;
            var at = -1;
            for (var i = from + 1; i < to; i++)
            {
                var v = points[i] - a;
                var t = square > 0 ? Math.Min(Math.Max((v.X * d.X + v.Y * d.Y) / square, 0), 1) : 0;
                var off = Math.Max((v - d * t).LengthXY / tolerance, Math.Abs(widths[i] - (wa + (wb - wa) * t)) / widthTolerance);
                if (off > worst) (worst, at) = (off, i);
            }
            if (at < 0) continue;
            keep[at] = true;
            work.Push((from, at));
            work.Push((at, to));
        }
        var kept = new List<Vec3>();
        var keptWidths = new List<double>();
        for (var i = 0; i < n; i++)
        {
            if (!keep[i]) continue;
            kept.Add(points[i]);
            keptWidths.Add(widths[i]);
        }
        return (kept.ToArray(), keptWidths.ToArray());
    }
}
