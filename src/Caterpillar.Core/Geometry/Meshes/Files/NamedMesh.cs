namespace Caterpillar.Geometry;

/// <summary>A mesh and its name in the file (or the name of the file if it has none).</summary>
public sealed record NamedMesh
{
    /// <summary>As in its file.</summary>
    public string Name { get; }

    /// <summary>Its surface, mm.</summary>
    public TriMesh Mesh { get; }

    /// <summary>A mesh and its name.</summary>
    public NamedMesh(string name, TriMesh mesh)
    {
        Name = name ?? throw new ArgumentNullException(nameof(name));
        Mesh = mesh ?? throw new ArgumentNullException(nameof(mesh));
    }
}
