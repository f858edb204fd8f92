using System;

namespace Caterpillar.Geometry;

/// <summary>
/// Removes points that a plane through vertices leaves in contours: repeated ones, spikes that go back on themselves, and on request exactly collinear ones.
/// </summary>
internal static class PolylineCleaning
{
    /// <summary>Keeps one of equal neighbors.</summary>
    public static void DropRepeats(Vec3[] points, ref int count)
    {
        var kept = 0;
        for (var i = 0; i < count; i++)
        {
            if (kept == 0 || points[i] != points[kept - 1]) points[kept++] = points[i];
        }
        count = kept;
    }

    /// <summary>
    /// For a closed contour: also removes spikes that go to a point and back over the same points. Returns the index of the first point that
    /// is kept.
    /// </summary>
    public static int DropSpikes(Vec3[] points, ref int count)
    {
        var end = 0;
        for (var i = 0; i < count; i++)
        {
            var p = points[i];
            if (end > 0 && points[end - 1] == p) continue;
            if (end > 1 && points[end - 2] == p) end--;
            else points[end++] = p;
        }
        var start = 0;
        while (end - start > 1)
        {
            if (points[end - 1] == points[start]) end--;
            else if (end - start > 2 && points[end - 2] == points[start]) end--;
            else if (end - start > 2 && points[end - 1] == points[start + 1]) start++;
            else break;
        }
        count = end - start;
        return start;
    }

    /// <summary>A polyline of the points, which are copied.</summary>
    public static Polyline ToPolyline(Vec3[] points, int count, bool closed, bool mergeCollinear, int start = 0)
    {
        var copy = new Vec3[count];
        if (!mergeCollinear || count < 3)
        {
            Array.Copy(points, start, copy, 0, count);
            return Polyline.Own(copy, closed);
        }
        var kept = 0;
        for (var i = 0; i < count; i++)
        {
            var inside = closed || (i > 0 && i < count - 1);
            var before = kept > 0 ? copy[kept - 1] : points[start + count - 1];
            var after = points[start + (i + 1 == count ? 0 : i + 1)];
            if (inside && IsBetween(before, points[start + i], after)) continue;
            copy[kept++] = points[start + i];
        }
        // The last one that was kept comes after the first: check it again now that its successor is known.
        while (closed && kept > 3 && IsBetween(copy[kept - 2], copy[kept - 1], copy[0])) kept--;
        if (closed && kept < 3)
        {
            kept = count;
            Array.Copy(points, start, copy, 0, count);
        }
        Array.Resize(ref copy, kept);
        return Polyline.Own(copy, closed);
    }

    // Exactly on the line and in the same direction.
    private static bool IsBetween(Vec3 a, Vec3 b, Vec3 c)
    {
        double ux = b.X - a.X, uy = b.Y - a.Y, vx = c.X - b.X, vy = c.Y - b.Y;
        return ux * vy == uy * vx && ux * vx + uy * vy > 0;
    }
}
