namespace Caterpillar.Curved;

/// <summary>A connected piece of a layer: an outline with the holes in it, which it spans.</summary>
internal sealed class SpanIsland
{
    // From afar a coarser outline will do: from so many steps between nodes on, one that lies off by so much, mm.
    private static readonly (int Steps, double Tolerance)[] Coarser = [(6, 0.016), (16, 0.064), (40, 0.256)];
    private readonly List<Vec3[]> _curves;
    private readonly MeanValueSpan[] _spans;

    private SpanIsland(List<Vec3[]> curves)
    {
        _curves = curves;
        _spans = [new MeanValueSpan(curves), .. Coarser.Select(c => new MeanValueSpan(curves.ConvertAll(curve => Thinned(curve, c.Tolerance))))];
    }

    public static List<SpanIsland> Of(List<Vec3[]> curves)
    {
        var outlines = curves.Where(c => Area(c) > 0).OrderBy(Area).ToArray();
        if (outlines.Length == 0) return [new SpanIsland(curves)];
        var members = Array.ConvertAll(outlines, o => new List<Vec3[]> { o });
        foreach (var hole in curves.Where(c => !(Area(c) > 0)))
        {
            // The smallest outline around it.
            var owner = Array.FindIndex(outlines, o => Edges(o).Sum(e => MeshHeights.Crossing(e.From, e.To, hole[0])) != 0);
            if (owner >= 0) members[owner].Add(hole);
        }
        return members.Select(m => new SpanIsland(m)).ToList();
    }

    /// <summary>For each node of a grid the number of the island inside of which it lies, or −1. The grid reaches beyond all islands.</summary>
    public static int[] Owners(List<SpanIsland> islands, SlopeGrid grid)
    {
        var owners = Enumerable.Repeat(-1, grid.Count).ToArray();
        for (var i = 0; i < islands.Count; i++)
        {
            var turns = new int[grid.Count];
            foreach (var (from, to) in islands[i]._curves.SelectMany(Edges)) Cross(from, to, grid, turns);
            var turn = 0;
            for (var n = 0; n < turns.Length; n++)
            {
                turn += turns[n];
                if (turn != 0) owners[n] = i;
            }
        }
        return owners;
    }

    /// <summary>Nodes of a grid next to the curves, some more than once.</summary>
    public IEnumerable<int> NodesAlong(SlopeGrid grid)
    {
        foreach (var (from, to) in _curves.SelectMany(Edges))
        {
            var parts = Math.Ceiling((to - from).LengthXY / grid.Cell);
            for (var i = 0; i < parts; i++)
            {
                var place = Vec3.Lerp(from, to, i / parts);
                yield return grid.Locate(place.X, place.Y).Node;
            }
        }
    }

    /// <summary>The height over a place, so many steps between nodes away from the curves, mm.</summary>
    public double Height(double x, double y, int steps)
    {
        var span = Coarser.Length;
        while (span > 0 && steps < Coarser[span - 1].Steps) span--;
        return _spans[span].Height(x, y);
    }

    // The turns about the nodes to the right of where an edge crosses their rows: added up along a row, those about each node.
    private static void Cross(Vec3 from, Vec3 to, SlopeGrid grid, int[] turns)
    {
        var (low, high) = from.Y < to.Y ? (from, to) : (to, from);
        for (var row = (int)Math.Ceiling((low.Y - grid.Corner.Y) / grid.Cell); grid.Corner.Y + row * grid.Cell < high.Y; row++)
        {
            var x = low.X + (high.X - low.X) * (grid.Corner.Y + row * grid.Cell - low.Y) / (high.Y - low.Y);
            turns[row * grid.Columns + (int)Math.Ceiling((x - grid.Corner.X) / grid.Cell)] += from.Y < to.Y ? 1 : -1;
        }
    }

    private static IEnumerable<(Vec3 From, Vec3 To)> Edges(Vec3[] curve) => curve.Select((p, i) => (p, curve[i + 1 < curve.Length ? i + 1 : 0]));

    private static Vec3[] Thinned(Vec3[] curve, double tolerance)
    {
        var thinned = LineThinner.Thin([.. curve, curve[0]], tolerance);
        return thinned.Count > 2 ? thinned.ToArray() : curve;
    }

    private static double Area(Vec3[] curve) => 2 * Polyline.Own(curve, closed: true).SignedAreaXY;
}
