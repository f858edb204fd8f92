namespace Caterpillar.Slicing;

/// <summary>Places of the tips of trees: along the edges of what they hold and within.</summary>
/// <param name="spacing">Distance between tips, mm.</param>
/// <param name="width">Of lines, mm.</param>
internal sealed class TreeTips(double spacing, double width)
{
    private const double ArcTolerance = 0.05;

    // Of the spacing; tips are no nearer to each other.
    private const double Nearest = 0.7;
    private readonly Dictionary<(int, int, int), List<Vec3>> _all = [];
    private readonly RegionEngine _engine = new();

    /// <summary>The tips below an area, in addition to those below others. From the lowest area up: what leans out less far is held from below.</summary>
    public List<Vec3> Below(Region area, double z)
    {
        var tips = new List<Vec3>();
        foreach (var island in area.Islands)
        {
            var count = tips.Count;
            // So that the outermost extrusions of what tips carry have both ends of each span on one.
            var edge = island.Offset(-width / 2, JoinStyle.Miter, 2, ArcTolerance, _engine);
            if (edge.IsEmpty) edge = island;
            // Rows of what tips carry begin and end on one.
            var rows = edge.HatchLines(0, spacing);
            foreach (var row in rows.Where(r => r.From.DistanceTo(r.To) >= spacing))
            {
                Add(row.From.WithZ(z), tips);
                Add(row.To.WithZ(z), tips);
            }
            foreach (var contour in edge.Contours)
            {
                var length = contour.Length;
                // A small place has its tip in the middle.
                if (length < spacing) continue;
                var steps = Math.Ceiling(length / spacing);
                for (var k = 0; k < steps; k++) Add(LoopPlace.AtLength(contour.Raw, length * k / steps).Point.WithZ(z), tips);
            }
            foreach (var row in rows)
            {
                for (var x = Math.Ceiling(row.From.X / spacing) * spacing; x <= row.To.X; x += spacing) Add(new Vec3(x, row.From.Y, z), tips);
            }
            if (tips.Count == count && Middle(island) is { } middle) Add(middle.WithZ(z), tips);
        }
        return tips;
    }

    private void Add(Vec3 tip, List<Vec3> tips)
    {
        int Cell(double v) => (int)Math.Floor(v / spacing);
        var (x, y, z) = (Cell(tip.X), Cell(tip.Y), Cell(tip.Z));
        for (var k = 0; k < 27; k++)
        {
            if (_all.TryGetValue((x + k % 3 - 1, y + k / 3 % 3 - 1, z + k / 9 - 1), out var near)
                && near.Exists(t => t.DistanceTo(tip) < Nearest * spacing)) return;
        }
        if (!_all.TryGetValue((x, y, z), out var cell)) _all.Add((x, y, z), cell = []);
        cell.Add(tip);
        tips.Add(tip);
    }

    // A point well inside: the middle of the longest level line at half its height.
    private static Vec3? Middle(Region island)
    {
        var box = island.Bounds;
        Vec3? middle = null;
        var longest = 0.0;
        foreach (var line in island.HatchLines(0, box.Size.Y + 1, box.Center.Y))
        {
            if (line.From.DistanceTo(line.To) <= longest) continue;
            longest = line.From.DistanceTo(line.To);
            middle = Vec3.Lerp(line.From, line.To, 0.5);
        }
        return middle;
    }
}
