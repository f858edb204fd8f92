using Caterpillar.Geometry;
using Caterpillar.Toolpaths;

namespace Caterpillar.Planning;

/// <summary>
/// The path that the head has taken, for returns along it. Each return cuts off what lies beyond its goal, so that all returns together visit every point once.
/// </summary>
internal sealed class ReturnPath(PlanRules rules)
{
    // Below what a travel may touch by the checks, mm.
    private const double Touch = 0.03;

    // As far below the top of what is printed as the checks look exactly, mm.
    private const double Depth = 6;
    private readonly Deposit _printed = new(rules.Cell, Depth);
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

    /// <summary>An object on the bed.</summary>
    public void Avoid(TriMesh obstacle) => Obstacle.AddTo(_printed, obstacle);

    /// <summary>A path has been printed.</summary>
    public void Print(PrintPath path)
    {
        Visit(path.Start);
        for (var i = 0; i < path.SegmentCount; i++)
        {
            Vec3 from = path.Points[i], to = path.EndOf(i);
            if (path.ArcOf(i) is { } arc)
            {
                var chords = arc.ChordCount(from, WipePath.Tolerance);
                for (var k = 1; k < chords; k++) Visit(arc.PointAt(from, to, (double)k / chords));
            }
            Visit(to);
            // The wider where it is pressed flat.
            var bead = path.BeadOf(i);
            var round = 2 * Math.Sqrt(bead.Area / Math.PI);
            var flat = bead with { Height = Math.Min(bead.Height > 0 ? bead.Height : rules.LayerHeight, round) };
            _printed.Add(from, to, flat, path.ArcOf(i), rules.Shape);
        }
    }

    /// <summary>What the head does to the print where its tip is at a point: no route down to it does more.</summary>
    public HeadContact At(Vec3 point) => Along(point, [point]);

    /// <summary>The worst that the head does to the print along a path: nozzle, head and boxes as the checks know them.</summary>
    public HeadContact Along(Vec3 from, List<Vec3> path)
    {
        var worst = HeadContact.None;
        foreach (var to in path)
        {
            var contact = _printed.Meets(from, to, Touch, rules.Outline, false, out _);
            if (contact > worst) worst = contact;
            foreach (var box in rules.HeadBoxes)
            {
                if (_printed.MeetsBox(from, to, Touch, box, out _)) worst = HeadContact.Hits;
            }
            from = to;
        }
        return worst;
    }
}
