namespace Caterpillar.Geometry;

/// <summary>Sorts the half-edges around a vertex counterclockwise from due west, exactly; equal directions by the number of the edge.</summary>
internal sealed class HalfEdgeSorter : IComparer<int>
{
    private PlanarGraph? _graph;
    private GridPoint _center;

    public void Sort(PlanarGraph graph, int v, int start, int end)
    {
        _graph = graph;
        _center = graph.Vertices.Points[v];
        var half = graph.Half;
        if (end - start > 12)
        {
            Array.Sort(half, start, end - start, this);
            return;
        }
        for (var i = start + 1; i < end; i++)
        {
            var h = half[i];
            var k = i;
            for (; k > start && Compare(half[k - 1], h) > 0; k--) half[k] = half[k - 1];
            half[k] = h;
        }
    }

    public int Compare(int g, int h)
    {
        if (g == h) return 0;
        var p = _graph!.Vertices.Points[_graph.Other(g)];
        var q = _graph.Vertices.Points[_graph.Other(h)];
        var byHalf = Quadrants(p).CompareTo(Quadrants(q));
        if (byHalf != 0) return byHalf;
        var cross = Grid.Cross(_center, p, q);
        return cross > 0 ? -1 : cross < 0 ? 1 : g.CompareTo(h);
    }

    // Due west, below, the rest (due east and above).
    private int Quadrants(GridPoint p) => p.Y < _center.Y ? 1 : p.Y > _center.Y || p.X > _center.X ? 2 : 0;
}
