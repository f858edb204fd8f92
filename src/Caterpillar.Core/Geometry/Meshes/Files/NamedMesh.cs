namespace Caterpillar.Geometry;

/// <summary>A mesh with the name that its file gives it, or the file name if it has none.</summary>
/// <param name="Name">The name, for messages and settings of one model.</param>
/// <param name="Mesh">The mesh, mm.</param>
public sealed record NamedMesh(string Name, TriMesh Mesh);
