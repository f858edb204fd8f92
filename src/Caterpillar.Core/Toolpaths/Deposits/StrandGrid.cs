namespace Caterpillar.Toolpaths;

/// <summary>A flat piece of something that a head may hit: of an extrusion, as wide as it is across the tool that printed it, or of a surface.</summary>
/// <param name="Body">The piece.</param>
/// <param name="Line">Its middle line, if it is one of an extrusion; the same body otherwise.</param>
/// <param name="Tag">A number of the caller.</param>
internal sealed record Strand(ConvexBody Body, ConvexBody Line, int Tag);

/// <summary>Extrusions and surfaces in space, in boxes of boxes, for heads that come from any side. Not thread-safe.</summary>
internal sealed class StrandGrid
{
    // Sides of the boxes, mm; longer pieces are divided.
    private const double Small = 4;
    private const double Large = 32;

    // mm; far less than what is printed.
    private const double Touch = 1e-6;
    private readonly Dictionary<(int, int, int), Box> _boxes = [];

    // How far a piece stands out of the box of its middle, mm.
    private double _reach;

    /// <summary>Adds an extrusion.</summary>
    public void Add(Vec3 from, Vec3 to, double half, Vec3 normal, int tag)
    {
        var count = (int)Math.Min(1e5, Math.Max(1, Math.Ceiling(from.DistanceTo(to) / Small)));
        for (var k = 0; k < count; k++)
        {
            Vec3 a = Vec3.Lerp(from, to, (double)k / count), b = Vec3.Lerp(from, to, (k + 1.0) / count);
            ConvexBody body = new(new Disc(a, normal, half), new Disc(b, normal, half)), line = new(new Disc(a, normal, 0), new Disc(b, normal, 0));
            Put(new Strand(body, line, tag), (a + b) / 2);
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
        var body = new ConvexBody(new Disc(a, Vec3.UnitZ, 0), new Disc(b, Vec3.UnitZ, 0), new Disc(c, Vec3.UnitZ, 0));
        Put(new Strand(body, body, tag), (a + b + c) / 3);
    }

    /// <summary>The strands in boxes that come near a body.</summary>
    /// <param name="body">The body.</param>
    /// <param name="distance">The distance, mm.</param>
    /// <param name="apart">A direction in which the body probably lies beyond them.</param>
    public IEnumerable<Strand> Near(ConvexBody body, double distance, Vec3 apart)
    {
        var around = body.Bounds.Grow(distance);
        foreach (var box in Around(_boxes, around, Large))
        {
            if (!Meets(box.Bounds)) continue;
            foreach (var part in Around(box.Parts, around, Small))
            {
                if (!Meets(part.Bounds)) continue;
                foreach (var strand in part.Strands) yield return strand;
            }
        }

        bool Meets(Bounds box) => Overlap(box, around) && body.Meets(ConvexBody.Of(box, Affine.Identity), distance, apart);
    }

    /// <summary>Distance from a point backward along a direction to what is there, mm; infinity for nothing.</summary>
    public double Below(Vec3 p, Vec3 direction, double most)
    {
        var nearest = double.PositiveInfinity;
        var ray = new ConvexBody(new Disc(p, direction, 0), new Disc(p - direction * most, direction, 0));
        foreach (var strand in Near(ray, 0, Vec3.UnitX))
        {
            if (!ray.Meets(strand.Body, Touch, Vec3.UnitX)) continue;
            // Where it is: by halves.
            double low = 0, high = most;
            for (var k = 0; k < 24; k++)
            {
                var middle = (low + high) / 2;
                var part = new ConvexBody(new Disc(p, direction, 0), new Disc(p - direction * middle, direction, 0));
                if (part.Meets(strand.Body, Touch, Vec3.UnitX)) high = middle;
                else low = middle;
            }
            nearest = Math.Min(nearest, high);
        }
        return nearest;
    }

    // The boxes around a place; what is in them may stand out.
    private IEnumerable<Box> Around(Dictionary<(int, int, int), Box> boxes, Bounds around, double side)
    {
        var (low, high) = (around.Grow(_reach).Min, around.Grow(_reach).Max);
        var count = (high.X - low.X + 2 * side) * (high.Y - low.Y + 2 * side) * (high.Z - low.Z + 2 * side) / (side * side * side);
        if (count > boxes.Count)
        {
            foreach (var pair in boxes) yield return pair.Value;
            yield break;
        }
        for (var x = Index(low.X, side); x <= Index(high.X, side); x++)
        {
            for (var y = Index(low.Y, side); y <= Index(high.Y, side); y++)
            {
                for (var z = Index(low.Z, side); z <= Index(high.Z, side); z++)
                {
                    if (boxes.TryGetValue((x, y, z), out var box)) yield return box;
                }
            }
        }
    }

    private static bool Overlap(Bounds a, Bounds b)
        => a.Min.X <= b.Max.X && b.Min.X <= a.Max.X && a.Min.Y <= b.Max.Y && b.Min.Y <= a.Max.Y && a.Min.Z <= b.Max.Z && b.Min.Z <= a.Max.Z;

    private static int Index(double x, double side) => (int)Math.Floor(x / side);

    private static (int, int, int) Place(Vec3 p, double side) => (Index(p.X, side), Index(p.Y, side), Index(p.Z, side));

    private void Put(Strand strand, Vec3 middle)
    {
        var bounds = strand.Body.Bounds;
        _reach = Math.Max(_reach, Math.Max((bounds.Max - middle).Length, (bounds.Min - middle).Length));
        var box = Find(_boxes, Place(middle, Large));
        box.Bounds = box.Bounds.Include(bounds);
        var part = Find(box.Parts, Place(middle, Small));
        part.Bounds = part.Bounds.Include(bounds);
        part.Strands.Add(strand);
    }

    private static Box Find(Dictionary<(int, int, int), Box> boxes, (int, int, int) place)
    {
        if (!boxes.TryGetValue(place, out var box)) boxes.Add(place, box = new Box());
        return box;
    }

    private sealed class Box
    {
        public Bounds Bounds;
        public Dictionary<(int, int, int), Box> Parts { get; } = [];
        public List<Strand> Strands { get; } = [];
    }
}
