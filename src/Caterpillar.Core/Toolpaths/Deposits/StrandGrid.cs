namespace Caterpillar.Toolpaths;

/// <summary>A flat piece of something that a head may hit: of an extrusion, as wide as it is across the tool that printed it, or of a surface.</summary>
/// <param name="Body">The piece.</param>
/// <param name="Tag">A number of the caller.</param>
internal sealed record Strand(ConvexBody Body, int Tag)
{
    /// <summary>The axis-parallel box around it.</summary>
    public Bounds Bounds { get; } = Body.Bounds;
}

/// <summary>Extrusions and surfaces in space, in boxes of boxes, for heads that come from any side. Not thread-safe.</summary>
internal sealed class StrandGrid
{
    // Longer pieces are divided, mm.
    private const double Small = 4;

    // Of a length of a few mm this leaves less than a micrometer.
    private const int Halves = 14;

    // mm; far less than what is printed.
    private const double Touch = 1e-6;

    // Sides of the boxes, and of the boxes in them down to the smallest, mm.
    private static readonly double[] Sides = [16 * Small, 4 * Small, Small, Small / 4];
    private readonly Dictionary<(int, int, int), Box> _boxes = [];
    private readonly List<Strand> _near = [];

    // How far a piece stands out of the box of its middle, mm.
    private double _reach;

    /// <summary>Adds an extrusion.</summary>
    public void Add(Vec3 from, Vec3 to, double half, Vec3 normal, int tag)
    {
        var count = (int)Math.Min(1e5, Math.Max(1, Math.Ceiling(from.DistanceTo(to) / Small)));
        for (var k = 0; k < count; k++)
        {
            Vec3 a = Vec3.Lerp(from, to, (double)k / count), b = Vec3.Lerp(from, to, (k + 1.0) / count);
            Put(new Strand(new ConvexBody(new Disc(a, normal, half), new Disc(b, normal, half)), tag), (a + b) / 2);
        }
    }

    /// <summary>Adds a triangle of a surface.</summary>
    public void Add(Vec3 a, Vec3 b, Vec3 c, int tag)
    {
        double ab = a.DistanceTo(b), bc = b.DistanceTo(c), ca = c.DistanceTo(a), most = Math.Max(ab, Math.Max(bc, ca));
        if (most > 2 * Small)
        {
            // Across the longest side.
            if (bc == most) (a, b, c) = (b, c, a);
            else if (ca == most) (a, b, c) = (c, a, b);
            var middle = (a + b) / 2;
            Add(a, middle, c, tag);
            Add(middle, b, c, tag);
            return;
        }
        Put(new Strand(new ConvexBody(new Disc(a, Vec3.UnitZ, 0), new Disc(b, Vec3.UnitZ, 0), new Disc(c, Vec3.UnitZ, 0)), tag), (a + b + c) / 3);
    }

    /// <summary>The strands that may come near a body. The list is used again by the next call.</summary>
    /// <param name="body">The body.</param>
    /// <param name="distance">The distance, mm.</param>
    /// <param name="apart">A direction in which the body probably lies beyond them.</param>
    /// <param name="comes">False for boxes to which the body surely does not come; null = nothing is known of it.</param>
    public IReadOnlyList<Strand> Near(ConvexBody body, double distance, Vec3 apart, Func<Bounds, bool>? comes = null)
    {
        _near.Clear();
        // What is there mostly lies below the lowest point of a head: most of it is told apart by this alone.
        var low = Vec3.Dot(body.Farthest(-apart), apart) - distance;
        Visit(_boxes, 0, new Query(body.Bounds.Grow(distance), apart, low, comes));
        return _near;
    }

    /// <summary>Distance from a point backward along a direction to what is there, mm; infinity for nothing.</summary>
    /// <param name="p">The point.</param>
    /// <param name="direction">The direction, of length 1.</param>
    /// <param name="most">What is farther does not count, mm.</param>
    /// <param name="exactly">If not, <paramref name="most"/> stands for all that is not farther.</param>
    public double Below(Vec3 p, Vec3 direction, double most, bool exactly)
    {
        var nearest = double.PositiveInfinity;
        var ray = Ray(most);
        foreach (var strand in Near(ray, 0, Vec3.UnitX))
        {
            if (!ray.Meets(strand.Body, Touch, Vec3.UnitX)) continue;
            if (!exactly) return most;
            // Where it is: by halves.
            double low = 0, high = Math.Min(most, nearest);
            for (var k = 0; k < Halves; k++)
            {
                var middle = (low + high) / 2;
                if (Ray(middle).Meets(strand.Body, Touch, Vec3.UnitX)) high = middle;
                else low = middle;
            }
            nearest = high;
            ray = Ray(nearest);
        }
        return nearest;

        ConvexBody Ray(double length) => new(new Disc(p, direction, 0), new Disc(p - direction * length, direction, 0));
    }

    // What is in the boxes around a place may stand out of them.
    private void Visit(Dictionary<(int, int, int), Box> boxes, int level, in Query query)
    {
        var side = Sides[level];
        var (low, high) = (query.Around.Grow(_reach).Min, query.Around.Grow(_reach).Max);
        var count = (high.X - low.X + 2 * side) * (high.Y - low.Y + 2 * side) * (high.Z - low.Z + 2 * side) / (side * side * side);
        if (count > boxes.Count)
        {
            foreach (var pair in boxes) Visit(pair.Value, level, query);
            return;
        }
        for (var x = Index(low.X, side); x <= Index(high.X, side); x++)
        {
            for (var y = Index(low.Y, side); y <= Index(high.Y, side); y++)
            {
                for (var z = Index(low.Z, side); z <= Index(high.Z, side); z++)
                {
                    if (boxes.TryGetValue((x, y, z), out var box)) Visit(box, level, query);
                }
            }
        }
    }

    private void Visit(Box box, int level, in Query query)
    {
        if (!query.IsNear(box.Bounds)) return;
        if (level + 1 < Sides.Length) Visit(box.Parts, level + 1, query);
        foreach (var row in box.Rows)
        {
            if (!query.IsNear(row.Bounds)) continue;
            foreach (var strand in row.Strands)
            {
                if (query.IsNear(strand.Bounds)) _near.Add(strand);
            }
        }
    }

    private static int Index(double x, double side) => (int)Math.Floor(x / side);

    private void Put(Strand strand, Vec3 middle)
    {
        _reach = Math.Max(_reach, Math.Max((strand.Bounds.Max - middle).Length, (strand.Bounds.Min - middle).Length));
        var boxes = _boxes;
        foreach (var side in Sides)
        {
            var box = Find(boxes, (Index(middle.X, side), Index(middle.Y, side), Index(middle.Z, side)));
            box.Bounds = box.Bounds.Include(strand.Bounds);
            boxes = box.Parts;
            if (side == Sides[Sides.Length - 1]) box.Add(strand);
        }
    }

    private static Box Find(Dictionary<(int, int, int), Box> boxes, (int, int, int) place)
    {
        if (!boxes.TryGetValue(place, out var box)) boxes.Add(place, box = new Box());
        return box;
    }

    // Matches what reaches into a box, at least to a height along a direction, where a body may come.
    private readonly struct Query(Bounds around, Vec3 apart, double low, Func<Bounds, bool>? comes)
    {
        public Bounds Around => around;

        public bool IsNear(in Bounds box)
            => box.Min.X <= around.Max.X && around.Min.X <= box.Max.X && box.Min.Y <= around.Max.Y && around.Min.Y <= box.Max.Y
                && box.Min.Z <= around.Max.Z && around.Min.Z <= box.Max.Z && Highest(box) >= low && comes?.Invoke(box) != false;

        // The end of a box along the direction.
        private double Highest(in Bounds box)
            => Math.Max(box.Min.X * apart.X, box.Max.X * apart.X) + Math.Max(box.Min.Y * apart.Y, box.Max.Y * apart.Y)
                + Math.Max(box.Min.Z * apart.Z, box.Max.Z * apart.Z);
    }

    private sealed class Box
    {
        public Bounds Bounds { get; set; }

        public Dictionary<(int, int, int), Box> Parts { get; } = [];

        public List<Row> Rows { get; } = [];

        public void Add(Strand strand)
        {
            if (Rows.Count == 0 || Rows[Rows.Count - 1].Strands.Count == Row.Most) Rows.Add(new Row());
            Rows[Rows.Count - 1].Add(strand);
        }
    }

    // Strands of one box that were added one after the other: mostly of one layer.
    private sealed class Row
    {
        public const int Most = 12;

        public Bounds Bounds { get; private set; }

        public List<Strand> Strands { get; } = [];

        public void Add(Strand strand)
        {
            Bounds = Bounds.Include(strand.Bounds);
            Strands.Add(strand);
        }
    }
}
