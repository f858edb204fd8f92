namespace Caterpillar.Geometry;

/// <summary>A mesh with the name that its file gives it, or the file name if it has none.</summary>
public sealed record NamedMesh
{
    /// <summary>The name, for messages and settings of one model.</summary>
    public string Name { get; }

    /// <summary>The mesh, mm.</summary>
    public TriMesh Mesh { get; }

    /// <summary>A mesh and its name.</summary>
    public NamedMesh(string name, TriMesh mesh)
    {
        Name = name ?? throw new ArgumentNullException(nameof(name));
        Mesh = mesh ?? throw new ArgumentNullException(nameof(mesh));
    }
}
