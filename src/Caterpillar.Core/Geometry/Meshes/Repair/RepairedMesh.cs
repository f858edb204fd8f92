namespace Caterpillar.Geometry;

/// <summary>A mesh after <see cref="MeshRepair"/>, and what was done to it. Immutable.</summary>
/// <param name="Mesh">The mesh; the same object where nothing was done.</param>
/// <param name="MovedVertices">Vertices that were moved to join rims that nearly meet.</param>
/// <param name="FarthestMove">How far at most, mm.</param>
/// <param name="DoubledFacets">Triangles that were there twice and are taken once.</param>
/// <param name="TurnedFacets">Triangles that were turned inside out against their neighbors, or all of them.</param>
/// <param name="Holes">Holes that were filled.</param>
/// <param name="LooseFacets">Triangles of loose pieces that enclose nothing, left out.</param>
/// <param name="TurnedBodies">Closed bodies that were inside out.</param>
internal sealed record RepairedMesh(
    TriMesh Mesh, int MovedVertices, double FarthestMove, int DoubledFacets, int TurnedFacets, IReadOnlyList<FilledHole> Holes,
    int LooseFacets, int TurnedBodies)
{
    /// <summary>True if something was changed.</summary>
    public bool IsChanged => MovedVertices > 0 || DoubledFacets > 0 || TurnedFacets > 0 || Holes.Count > 0 || LooseFacets > 0 || TurnedBodies > 0;

    /// <summary>A mesh to which nothing was done.</summary>
    public static RepairedMesh Unchanged(TriMesh mesh) => new(mesh, 0, 0, 0, 0, [], 0, 0);
}
