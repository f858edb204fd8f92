namespace Caterpillar.Geometry;

/// <summary>A mesh after <see cref="MeshRepair"/>, and its repairs. Immutable.</summary>
/// <param name="Mesh">The mesh. The same object if nothing was repaired.</param>
/// <param name="MovedVertices">Number of vertices that were moved to join naked edges.</param>
/// <param name="FarthestMove">Maximum distance of a move, mm.</param>
/// <param name="DuplicateFaces">Number of duplicate faces that were removed.</param>
/// <param name="FlippedFaces">Number of faces that were inside out and were flipped.</param>
/// <param name="Holes">Holes that were filled.</param>
/// <param name="LooseFaces">Number of faces of loose pieces that enclose nothing and were removed.</param>
/// <param name="FlippedBodies">Number of closed bodies that were inside out and were flipped.</param>
internal sealed record RepairedMesh(
    TriMesh Mesh, int MovedVertices, double FarthestMove, int DuplicateFaces, int FlippedFaces, IReadOnlyList<FilledHole> Holes,
    int LooseFaces, int FlippedBodies)
{
    /// <summary>A mesh to which nothing was done.</summary>
    public static RepairedMesh Unchanged(TriMesh mesh) => new(mesh, 0, 0, 0, 0, [], 0, 0);
}
