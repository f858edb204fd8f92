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

    // mm, and number of places, where the gap below an extrusion is looked at.
    private const double Sample = 0.5;
    private const int MostSamples = 256;
    private readonly Deposit _printed = new(rules.Cell, Depth);
    private readonly List<Vec3> _points = [];

    // The last path, whose end the nozzle touches.
    private PrintPath? _last;

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
        AddLast();
        _last = path;
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
        }
    }

    /// <summary>Where the head hits the print on every route: at its position or at the goal. Null if a route is free.</summary>
    public Vec3? Blocked(Vec3 from, Vec3 goal)
        => Contact(from, [from]) == HeadContact.Hits ? from : Along(goal, [goal]) == HeadContact.Hits ? goal : null;

    /// <summary>The worst that the head does to the print along a path: nozzle, head and boxes as the checks know them.</summary>
    public HeadContact Along(Vec3 from, List<Vec3> path)
    {
        AddLast();
        return Contact(from, path);
    }

    private void AddLast()
    {
        if (_last is not { } path) return;
        _last = null;
        for (var i = 0; i < path.SegmentCount; i++)
        {
            Vec3 from = path.Points[i], to = path.EndOf(i);
            var bead = path.BeadOf(i);
            _printed.Add(from, to, bead with { Height = HeightOf(path, bead, from, to) }, path.ArcOf(i), rules.Settings.BeadShape);
        }
    }

    // As the checks see it: the height of the layer, or the least gap below, or round where it hangs. The flatter, the wider, and the sooner it is hit.
    private double HeightOf(PrintPath path, in Bead bead, Vec3 from, Vec3 to)
    {
        if (path.Layer is { Thickness: > 0 } layer) return layer.Thickness;
        var usual = Math.Max(rules.Settings.LayerHeight, rules.Settings.FirstLayerHeight);
        var height = Math.Max(usual, 2 * Math.Sqrt(bead.Area / Math.PI));
        var samples = (int)Math.Min(Math.Ceiling(from.DistanceTo(to) / Sample), MostSamples);
        for (var k = 0; k < samples; k++)
        {
            var p = Vec3.Lerp(from, to, (k + 0.5) / samples);
            height = Math.Min(height, p.Z - Math.Max(0, _printed.TopUnder(p, p.Z - usual / 2, _printed.Cell)));
        }
        return Math.Max(height, usual / 2);
    }

    private HeadContact Contact(Vec3 from, List<Vec3> path)
    {
        var worst = HeadContact.None;
        foreach (var to in path)
        {
            var contact = _printed.Contacts.Meets(from, to, Touch, rules.Outline, false, out _);
            if (contact > worst) worst = contact;
            foreach (var box in rules.HeadBoxes)
            {
                if (_printed.Contacts.MeetsBox(from, to, Touch, box, out _)) worst = HeadContact.Hits;
            }
            from = to;
        }
        return worst;
    }
}
