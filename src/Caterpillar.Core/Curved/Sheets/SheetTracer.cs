namespace Caterpillar.Curved;

/// <summary>Makes the paths of one layer of a surface from its walls. For one layer.</summary>
/// <param name="walls">The walls of the surface.</param>
/// <param name="rules">Limits of the paths.</param>
/// <param name="slicing">Width and flow of the walls.</param>
/// <param name="shift">From the walls to the model, mm.</param>
internal sealed class SheetTracer(SheetWalls walls, LiftRules rules, SliceRules slicing, Vec3 shift)
{
    private readonly JoinedExtrusion _extrusion = new(rules.Tolerance / 2, rules.GapShare, rules.GapLength);
    private readonly Bead _bead = slicing.Bead(slicing.Walls.OuterWidth);
    private readonly List<PrintPath> _paths = [];

    /// <summary>Problems found on all paths so far.</summary>
    public LiftReport Report { get; } = new();

    /// <summary>The paths of a level, from 1.</summary>
    public IReadOnlyList<PrintPath> Trace(int level)
    {
        foreach (var (points, isClosed) in walls.Curves(level, rules.Tolerance / 2)) Follow(points, isClosed, level);
        return _paths.ToArray();
    }

    private void Follow(IReadOnlyList<SheetPoint> points, bool isClosed, int level)
    {
        // A loop with a gap begins in it.
        var first = 0;
        while (isClosed && first < points.Count && points[first].Height > 0) first++;
        var segments = isClosed ? points.Count : points.Count - 1;
        for (var i = 0; i < segments; i++) Divide(points[(first + i) % points.Count], points[(first + i + 1) % points.Count], level);
        var isWhole = isClosed && _extrusion.Points.Count > 3 && _extrusion.Points[0] == _extrusion.Points[_extrusion.Points.Count - 1];
        if (isWhole) _extrusion.Points.RemoveAt(_extrusion.Points.Count - 1);
        End(isWhole);
    }

    // Where the wall ends, or its height changes, in small pieces.
    private void Divide(SheetPoint a, SheetPoint b, int level)
    {
        var isEven = Math.Abs(a.Height - b.Height) <= rules.GapShare * Math.Min(a.Height, b.Height);
        if (!isEven && a.Point.DistanceTo(b.Point) > rules.Tolerance)
        {
            var middle = walls.At(Vec3.Lerp(a.Point, b.Point, 0.5), level);
            Divide(a, middle, level);
            Divide(middle, b, level);
        }
        else if (a.Height > 0 && b.Height > 0)
        {
            Add(a.Point + shift, b.Point + shift, (a.Height + b.Height) / 2);
        }
        else
        {
            End();
        }
    }

    private void Add(Vec3 from, Vec3 to, double height)
    {
        var length = from.DistanceTo(to);
        if (length == 0) return;
        var sunk = Math.Max(Sunk(from), Sunk(to));
        var slope = Angle.Atan2(Math.Abs(to.Z - from.Z), (to - from).LengthXY);
        if (sunk >= 0) Report.Below.Note(length, sunk, from);
        if (slope > rules.MaxSlope) Report.Steep.Note(length, slope, from);
        if (sunk >= 0 || (slope > rules.MaxSlope && rules.Partial)) End();
        else
        {
            var area = _bead.Area / _bead.Height * height;
            _extrusion.Add(from, to, new Bead(area, height), (area, area), keepsStart: false);
        }
    }

    private double Sunk(Vec3 point) => rules.Onto!.Height(point.X, point.Y) - point.Z;

    private void End(bool closed = false)
    {
        if (_extrusion.Points.Count > 1)
        {
            var path = new PrintPath(_extrusion.Points, _extrusion.Beads, closed);
            if (path.Length >= slicing.Walls.OuterWidth) _paths.Add(path);
        }
        _extrusion.Clear();
    }
}
