namespace Caterpillar.Geometry;

/// <summary>Removes points that a plane through vertices leaves in contours: repeated ones, and spikes that go back on themselves.</summary>
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
    /// For a closed contour: also removes spikes that go to a point and back over the same points. Returns the index of the first point that is kept.
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
    public static Polyline ToPolyline(Vec3[] points, int count, bool closed, int start = 0)
    {
        var copy = new Vec3[count];
        Array.Copy(points, start, copy, 0, count);
        return Polyline.Own(copy, closed);
    }
}
