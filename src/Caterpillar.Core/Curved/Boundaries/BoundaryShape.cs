namespace Caterpillar.Curved;

/// <summary>A surface, a set of curves, an open edge or vertices that mark a boundary of layers on a part.</summary>
public sealed class BoundaryShape
{
    private readonly Func<BoundaryMesh, double, int[]> _touched;

    private BoundaryShape(Func<BoundaryMesh, double, int[]> touched) => _touched = touched;

    /// <summary>A boundary from a surface that touches or cuts the part.</summary>
    /// <exception cref="ArgumentException">The mesh has no triangles.</exception>
    public static BoundaryShape Of(TriMesh surface)
    {
        var distance = new MeshDistance(surface ?? throw new ArgumentNullException(nameof(surface)));
        return Near(p => distance.Nearest(p).Point.DistanceTo(p));
    }

    /// <summary>A boundary from several shapes.</summary>
    public static BoundaryShape Of(IReadOnlyList<BoundaryShape> shapes)
    {
        if (shapes is null) throw new ArgumentNullException(nameof(shapes));
        return new BoundaryShape((mesh, near) => [.. shapes.SelectMany(s => s._touched(mesh, near)).Distinct().OrderBy(v => v)]);
    }

    /// <summary>A boundary from curves on the part.</summary>
    public static BoundaryShape Of(IReadOnlyList<Polyline> curves)
    {
        if (curves is null) throw new ArgumentNullException(nameof(curves));
        return Near(p =>
        {
            var least = double.PositiveInfinity;
            foreach (var curve in curves)
            {
                for (var i = 0; i < curve.SegmentCount; i++) least = Math.Min(least, p.DistanceToSegment(curve[i], curve[(i + 1) % curve.Count]));
            }
            return least;
        });
    }

    /// <summary>A boundary from vertex indices of the part, from 0. Indices that the part does not have touch nothing.</summary>
    public static BoundaryShape Of(IReadOnlyList<int> vertices)
    {
        if (vertices is null) throw new ArgumentNullException(nameof(vertices));
        return new BoundaryShape((mesh, _) =>
        {
            var count = mesh.Original.VertexCount;
            if (vertices.Any(v => v < 0 || v >= count)) return [];
            // Edges from one end to the other belong to neither.
            var own = vertices.Where(v => !mesh.Lower.Contains(v)).ToArray();
            return [.. BoundaryFinder.Between(mesh.Fine, count, mesh.Parents, own).Union(vertices).OrderBy(v => v)];
        });
    }

    /// <summary>A boundary from an open edge of the part.</summary>
    /// <param name="number">1 = the longest, 2 = the next.</param>
    public static BoundaryShape OpenEdge(int number)
    {
        if (number < 1) throw new ArgumentOutOfRangeException(nameof(number), "Edges are numbered from 1.");
        return new BoundaryShape((mesh, _) => BoundaryFinder.OpenLoops(mesh.Fine).OrderByDescending(loop => LengthOf(mesh.Fine, loop))
            .ElementAtOrDefault(number - 1) ?? []);
    }

    /// <summary>The vertices of the refined part on it.</summary>
    /// <param name="mesh">The part.</param>
    /// <param name="near">Maximum distance, mm; 0 = along it.</param>
    internal int[] On(BoundaryMesh mesh, double near) => _touched(mesh, near);

    private static BoundaryShape Near(Func<Vec3, double> distance)
        => new((mesh, near) => near > 0 ? BoundaryFinder.Within(mesh.Fine, distance, near) : BoundaryFinder.Along(mesh.Fine, distance, mesh.Edge / 2));

    private static double LengthOf(TriMesh mesh, int[] loop)
        => loop.Select((v, i) => mesh.RawVertices[v].DistanceTo(mesh.RawVertices[loop[(i + 1) % loop.Length]])).Sum();
}

/// <summary>A part, and the same with its long edges divided.</summary>
/// <param name="Original">The part.</param>
/// <param name="Fine">The divided one: the vertices of the part, then those that divide edges.</param>
/// <param name="Parents">The ends of the edge that each of the latter divides.</param>
/// <param name="Edge">Longest edge, mm.</param>
internal sealed record BoundaryMesh(TriMesh Original, TriMesh Fine, IReadOnlyList<(int A, int B)> Parents, double Edge)
{
    /// <summary>Vertices where layers start; none while they are looked for.</summary>
    public HashSet<int> Lower { get; init; } = [];
}
