namespace Caterpillar.Curved;

/// <summary>
/// The boundaries at which the layers of a mesh start and end: vertices at its lower and upper boundaries, of which it may have several. For
/// <see cref="LayerField.Harmonic"/> and <see cref="LayerField.Geodesic"/>.
/// </summary>
public sealed class MeshBoundaries
{
    private const int MostTriangles = 400_000;

    private MeshBoundaries(TriMesh original, TriMesh mesh, int[] lower, int[] upper) => (Original, Mesh, Lower, Upper) = (original, mesh, lower, upper);

    /// <summary>The mesh with its long edges divided.</summary>
    internal TriMesh Mesh { get; }

    /// <summary>Vertices of <see cref="Mesh"/> on the boundaries where layers begin.</summary>
    internal IReadOnlyList<int> Lower { get; }

    /// <summary>Vertices of <see cref="Mesh"/> on the boundaries where layers end.</summary>
    internal IReadOnlyList<int> Upper { get; }

    /// <summary>True if the lower boundary is level.</summary>
    internal bool StartLevel => Lower.Max(v => Mesh.RawVertices[v].Z) - Lower.Min(v => Mesh.RawVertices[v].Z) < 1e-3;

    /// <summary>The mesh as it was given.</summary>
    internal TriMesh Original { get; }

    /// <summary>
    /// Finds the boundaries. On an open mesh, layers start at the lowest naked edges and end at all others. On a closed mesh, they start at the face on the
    /// bed and end at upward smooth faces with sharp edges.
    /// </summary>
    /// <param name="mesh">The part at its position on the bed, mm.</param>
    /// <param name="cancel">Cancels the call.</param>
    /// <returns>The boundaries, or the error <c>curved.no_boundary</c> if none are found.</returns>
    public static Result<MeshBoundaries> Find(TriMesh mesh, CancellationToken cancel = default)
    {
        if (mesh is null) throw new ArgumentNullException(nameof(mesh));
        var fine = Fine(mesh, cancel);
        var (lower, upper) = mesh.NakedEdgeCount > 0 ? BoundaryFinder.OpenEdges(fine) : BoundaryFinder.SmoothFaces(fine);
        return Checked(mesh, fine, lower, upper, mesh.NakedEdgeCount > 0
            ? "An open mesh needs naked edges at its bottom and at its top." : "A closed mesh needs a face with sharp edges at its top.");
    }

    /// <summary>Boundaries from shapes on the part: the vertices near them.</summary>
    /// <param name="mesh">The part at its position on the bed, mm.</param>
    /// <param name="from">Shape at which layers start. Null = the bottom of the part.</param>
    /// <param name="to">Shapes at which layers end, one or more.</param>
    /// <param name="near">Maximum distance of vertices from the shapes, mm. 0 = vertices along the shapes, at most half an edge length away.</param>
    /// <param name="cancel">Cancels the call.</param>
    /// <returns>The boundaries, or the error <c>curved.no_boundary</c> if a shape touches no vertex.</returns>
    public static Result<MeshBoundaries> Near(
        TriMesh mesh, BoundaryShape? from, IReadOnlyList<BoundaryShape> to, double near = 0, CancellationToken cancel = default)
    {
        if (mesh is null) throw new ArgumentNullException(nameof(mesh));
        if (to is null) throw new ArgumentNullException(nameof(to));
        if (!(near >= 0) || double.IsInfinity(near)) throw new ArgumentOutOfRangeException(nameof(near), "The distance must not be negative.");
        var (fine, parents) = MeshRefiner.Refine(mesh, Edge(mesh), MostTriangles, cancel);
        var part = new BoundaryMesh(mesh, fine, parents, Edge(mesh));
        var lower = from is null ? BoundaryFinder.Lowest(fine) : from.On(part, near);
        part = part with { Lower = [.. lower] };
        var upper = new List<int>();
        for (var i = 0; i < to.Count; i++)
        {
            var touched = to[i].On(part, near);
            if (touched.Length == 0) return Missing($"Upper boundary {NumberFormatter.Format(i + 1)} touches no vertex of the part.");
            upper.AddRange(touched);
        }
        return Checked(mesh, fine, lower, upper.Distinct().OrderBy(v => v).ToArray(), "The boundaries touch no vertex of the part.");
    }

    /// <summary>Boundaries from vertex indices of the mesh.</summary>
    /// <exception cref="ArgumentOutOfRangeException">A vertex index is out of range.</exception>
    /// <returns>The boundaries, or the error <c>curved.no_boundary</c> if a set is empty or both share vertices.</returns>
    public static Result<MeshBoundaries> Of(TriMesh mesh, IReadOnlyList<int> lower, IReadOnlyList<int> upper)
    {
        if (mesh is null) throw new ArgumentNullException(nameof(mesh));
        if (lower is null) throw new ArgumentNullException(nameof(lower));
        if (upper is null) throw new ArgumentNullException(nameof(upper));
        if (lower.Concat(upper).Any(v => v < 0 || v >= mesh.VertexCount)) throw new ArgumentOutOfRangeException(nameof(lower), "The vertex does not exist.");
        if (lower.Count == 0 || upper.Count == 0) return Missing("Each boundary needs vertices.");
        return Near(mesh, BoundaryShape.Of(lower), [BoundaryShape.Of(upper)]);
    }

    /// <summary>True for the mesh of the boundaries, or one with the same triangles.</summary>
    internal bool IsOf(TriMesh mesh) => ReferenceEquals(Original, mesh) || (Original.RawVertices.AsEnumerable().SequenceEqual(mesh.RawVertices)
        && Original.RawTriangles.AsEnumerable().SequenceEqual(mesh.RawTriangles));

    /// <summary>A mesh with its long edges divided.</summary>
    internal static TriMesh Fine(TriMesh mesh, CancellationToken cancel = default) => MeshRefiner.Refine(mesh, Edge(mesh), MostTriangles, cancel).Mesh;

    private static double Edge(TriMesh mesh) => Math.Min(2, Math.Max(0.5, mesh.Bounds.Size.Length / 80));

    private static Result<MeshBoundaries> Checked(TriMesh original, TriMesh fine, int[] lower, int[] upper, string message)
    {
        var shared = new List<Diagnostic>();
        if (lower.Length == 0 || upper.Length == 0) return Missing(message);
        // Vertices of both are where layers start: lists of ends often hold all of them.
        var ends = upper.Except(lower).ToArray();
        if (ends.Length == 0) return Missing($"The upper and lower boundaries meet at {fine.RawVertices[upper[0]]} and leave no room for layers.");
        if (ends.Length < upper.Length)
        {
            shared.Add(new Diagnostic(Severity.Note, "curved.shared_boundary", "Vertices of both boundaries count as the lower one.", null,
                upper.Length - ends.Length));
            upper = ends;
        }
        var free = BoundaryFinder.Unreached(fine, lower) ?? BoundaryFinder.Unreached(fine, upper);
        if (free is { } piece) return Missing($"A piece of the part at {fine.RawVertices[piece]} is not connected to both boundaries.");
        return new Result<MeshBoundaries>(new MeshBoundaries(original, fine, lower, upper), shared);
    }

    private static Result<MeshBoundaries> Missing(string message) => new(null, [new Diagnostic(Severity.Error, "curved.no_boundary", message)]);
}
