using Caterpillar.Basics;
using Caterpillar.Geometry;

namespace Caterpillar.Curved;

/// <summary>
/// Where the layers of a mesh begin and end: sets of vertices at its lower and its upper boundaries, of which there may be several. For
/// <see cref="LayerField.Harmonic"/> and <see cref="LayerField.Geodesic"/>.
/// </summary>
public sealed class MeshBoundaries
{
    private const int MostTriangles = 400_000;

    private MeshBoundaries(TriMesh original, TriMesh mesh, int[] lower, int[] upper)
    {
        Original = original;
        Mesh = mesh;
        Lower = lower;
        Upper = upper;
    }

    /// <summary>The mesh, its edges divided where they were long.</summary>
    internal TriMesh Mesh { get; }

    /// <summary>Vertices of <see cref="Mesh"/> on the boundaries where layers begin.</summary>
    internal IReadOnlyList<int> Lower { get; }

    /// <summary>Vertices of <see cref="Mesh"/> on the boundaries where layers end.</summary>
    internal IReadOnlyList<int> Upper { get; }

    /// <summary>The mesh as it was given.</summary>
    internal TriMesh Original { get; }

    /// <summary>
    /// Found by themselves: of an open mesh the lowest open edges, and all others; of a closed one what it stands on, and its smooth faces that look up and
    /// fall away at their edges.
    /// </summary>
    /// <param name="mesh">The part where it is printed, mm.</param>
    /// <param name="cancel">Cancels.</param>
    /// <returns>None, with the error <c>curved.no_boundary</c>, where there are none.</returns>
    public static Result<MeshBoundaries> Find(TriMesh mesh, CancellationToken cancel = default)
    {
        if (mesh is null) throw new ArgumentNullException(nameof(mesh));
        var fine = Refined(mesh, cancel);
        var (lower, upper) = mesh.OpenEdgeCount > 0 ? BoundaryFinder.OpenEdges(fine) : BoundaryFinder.SmoothFaces(fine);
        return Checked(mesh, fine, lower, upper, mesh.OpenEdgeCount > 0
            ? "An open mesh needs naked edges at its bottom and at its top." : "A closed mesh needs a face with sharp edges at its top.");
    }

    /// <summary>Given by objects that lie on the part: its vertices that are near them.</summary>
    /// <param name="mesh">The part where it is printed, mm.</param>
    /// <param name="from">Where layers begin; null for the bottom of the part.</param>
    /// <param name="to">Where they end; one or several.</param>
    /// <param name="near">How far vertices may lie from the objects, mm; 0 for those that lie along them, at most half the length of an edge away.</param>
    /// <param name="cancel">Cancels.</param>
    /// <returns>None, with the error <c>curved.no_boundary</c>, where one of them touches nothing.</returns>
    public static Result<MeshBoundaries> Near(
        TriMesh mesh, BoundaryShape? from, IReadOnlyList<BoundaryShape> to, double near = 0, CancellationToken cancel = default)
    {
        if (mesh is null) throw new ArgumentNullException(nameof(mesh));
        if (to is null) throw new ArgumentNullException(nameof(to));
        if (!(near >= 0) || double.IsInfinity(near)) throw new ArgumentOutOfRangeException(nameof(near), "The distance must not be negative.");
        var fine = Refined(mesh, cancel);
        int[] Touched(BoundaryShape shape) => near > 0 ? BoundaryFinder.Within(fine, shape, near) : BoundaryFinder.Along(fine, shape, Edge(mesh) / 2);
        var lower = from is null ? BoundaryFinder.Lowest(fine) : Touched(from);
        var upper = new List<int>();
        for (var i = 0; i < to.Count; i++)
        {
            var touched = Touched(to[i]);
            if (touched.Length == 0) return Missing($"Upper boundary {NumberFormatter.Format(i + 1)} touches no vertex of the part.");
            upper.AddRange(touched);
        }
        return Checked(mesh, fine, lower, upper.Distinct().OrderBy(v => v).ToArray(), "The boundaries touch no vertex of the part.");
    }

    /// <summary>Given by vertices of the mesh.</summary>
    /// <exception cref="ArgumentOutOfRangeException">A number is not that of a vertex.</exception>
    /// <returns>None, with the error <c>curved.no_boundary</c>, where a set is empty or both share vertices.</returns>
    public static Result<MeshBoundaries> Of(TriMesh mesh, IReadOnlyList<int> lower, IReadOnlyList<int> upper)
    {
        if (mesh is null) throw new ArgumentNullException(nameof(mesh));
        if (lower is null) throw new ArgumentNullException(nameof(lower));
        if (upper is null) throw new ArgumentNullException(nameof(upper));
        if (lower.Concat(upper).Any(v => v < 0 || v >= mesh.VertexCount)) throw new ArgumentOutOfRangeException(nameof(lower), "The vertex does not exist.");
        var (fine, parents) = MeshRefiner.Refine(mesh, Edge(mesh), MostTriangles, CancellationToken.None);
        return Checked(mesh, fine, BoundaryFinder.Between(fine, mesh.VertexCount, parents, lower),
            BoundaryFinder.Between(fine, mesh.VertexCount, parents, upper), "Each boundary needs vertices.");
    }

    private static double Edge(TriMesh mesh) => Math.Min(2, Math.Max(0.5, mesh.Bounds.Size.Length / 80));

    private static TriMesh Refined(TriMesh mesh, CancellationToken cancel) => MeshRefiner.Refine(mesh, Edge(mesh), MostTriangles, cancel).Mesh;

    private static Result<MeshBoundaries> Checked(TriMesh original, TriMesh fine, int[] lower, int[] upper, string message)
    {
        if (lower.Length == 0 || upper.Length == 0) return Missing(message);
        var both = new HashSet<int>(lower);
        foreach (var v in upper)
        {
            if (both.Contains(v)) return Missing($"The upper and lower boundaries meet at {fine.RawVertices[v]} and leave no room for layers.");
        }
        var free = BoundaryFinder.Unreached(fine, lower) ?? BoundaryFinder.Unreached(fine, upper);
        if (free is { } piece) return Missing($"A piece of the part at {fine.RawVertices[piece]} is not connected to both boundaries.");
        return new Result<MeshBoundaries>(new MeshBoundaries(original, fine, lower, upper), []);
    }

    private static Result<MeshBoundaries> Missing(string message) => new(null, [new Diagnostic(Severity.Error, "curved.no_boundary", message)]);
}
