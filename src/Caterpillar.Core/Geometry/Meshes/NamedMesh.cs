using System;

namespace Caterpillar.Geometry;

/// <summary>A mesh and its name in the file (or the name of the file if it has none).</summary>
public sealed record NamedMesh
{
    public string Name { get; }

    public TriMesh Mesh { get; }

    public NamedMesh(string name, TriMesh mesh)
    {
        Name = name ?? throw new ArgumentNullException(nameof(name));
        Mesh = mesh ?? throw new ArgumentNullException(nameof(mesh));
    }
}
