namespace Caterpillar.Geometry;

/// <summary>A mesh with the name that its file gives it, or the file name if it has none.</summary>
public sealed record NamedMesh
{
    /// <summary>The name, for messages and settings of one model.</summary>
    public string Name { get; init; }

    /// <summary>The mesh, mm.</summary>
    public TriMesh Mesh { get; init => field = value ?? throw new ArgumentNullException(nameof(value)); }

    /// <summary>Settings of this mesh in a project of another slicer, in its words.</summary>
    public IReadOnlyDictionary<string, string> Settings { get; init; } = new Dictionary<string, string>();

    /// <summary>Transform from the position in the file to that of the mesh.</summary>
    public Affine Placed { get; init; } = Affine.Identity;

    /// <summary>A mesh and its name.</summary>
    public NamedMesh(string name, TriMesh mesh)
    {
        Name = name ?? throw new ArgumentNullException(nameof(name));
        Mesh = mesh;
    }

    /// <summary>The transformed mesh, which still knows its position in the file.</summary>
    /// <inheritdoc cref="TriMesh.Transformed" path="/exception"/>
    public NamedMesh Transformed(Affine map) => this with { Mesh = Mesh.Transformed(map), Placed = Placed.Then(map) };

    /// <summary>The mesh moved by a vector in mm.</summary>
    public NamedMesh Moved(Vec3 shift) => Transformed(Affine.Move(shift));
}
