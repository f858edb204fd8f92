using Caterpillar.Geometry;
using Caterpillar.Toolpaths;

namespace Caterpillar.Planning;

/// <summary>
/// The path that the head has taken, for returns along it. Each return cuts off what lies beyond its goal, so that all returns together visit every point once.
/// </summary>
internal sealed class ReturnPath
{
    private const double Flush = 1e-6;

    // A tip of half a millimeter then sinks by half an extrusion into the one uphill.
    private const double MaxSlope = 0.25;
    private readonly List<Vec3> _points = [];

    public void Visit(Vec3 point) => _points.Add(point);

    /// <summary>The points from the last visited one back to the goal, without the former; null if the head has not been there.</summary>
    public List<Vec3>? BackTo(Vec3 goal)
    {
        var back = new List<Vec3>();
        while (_points.Count > 0)
        {
            var last = _points[_points.Count - 1];
            if (last == goal)
            {
                if (back.Count > 0) back.RemoveAt(0);
                back.Add(goal);
                return back;
            }
            back.Add(last);
            _points.RemoveAt(_points.Count - 1);
        }
        _points.Add(goal);
        return null;
    }

    /// <summary>Length in mm of a path from a point.</summary>
    public static double Length(Vec3 from, List<Vec3> path)
    {
        var sum = 0.0;
        foreach (var to in path)
        {
            sum += from.DistanceTo(to);
            from = to;
        }
        return sum;
    }

    /// <summary>True if the tip can descend to a point: nothing printed lies on top of it.</summary>
    public static bool IsOpen(Deposit deposit, Vec3 point) => deposit.TopUnder(point, double.PositiveInfinity) <= point.Z + Flush;

    /// <summary>
    /// True if the tip can return along a path: nothing lies on top of it (what was printed along it is flush with it), and it is not so steep that the tip
    /// would plow through the extrusion uphill of it.
    /// </summary>
    public static bool IsOpen(Deposit deposit, Vec3 from, List<Vec3> path)
    {
        foreach (var to in path)
        {
            var flat = (to - from).LengthXY;
            if (Math.Abs(to.Z - from.Z) > MaxSlope * flat) return false;
            var pieces = (int)Math.Min(100_000, Math.Ceiling(flat / (deposit.Cell / 2) + 1));
            for (var i = 0; i <= pieces; i++)
            {
                if (!IsOpen(deposit, Vec3.Lerp(from, to, (double)i / pieces))) return false;
            }
            from = to;
        }
        return true;
    }
}
