namespace Caterpillar.Geometry;

/// <summary>An instance of an object: which one (in which part of the package, null for the same part) and how it is placed, in units of the file.</summary>
internal sealed record ThreeMfUse(string? Path, int ObjectId, Affine Map, int Line, int Column);

/// <summary>An object of a 3MF model: a mesh, or uses of other objects.</summary>
internal sealed class ThreeMfObject(string name, string type)
{
    public string Name { get; } = name;

    public string Type { get; } = type;

    public TriMesh? Mesh { get; set; }

    /// <summary>The numbers of triangles in the file that the mesh does not have, ascending.</summary>
    public List<int> Dropped { get; } = [];

    /// <summary>Painted faces, in units of the file.</summary>
    public List<ThreeMfPaint> Paint { get; } = [];

    public List<ThreeMfUse> Components { get; } = [];

    /// <summary>The triangles with these numbers in the file.</summary>
    public TriMesh Triangles(int first, int last)
    {
        var (from, to) = (Kept(first), Kept(last + 1));
        return TriMesh.Create(Mesh!.Vertices, Mesh.RawTriangles.Skip(3 * from).Take(3 * (to - from)).ToArray());

        int Kept(int number) => Math.Max(0, Math.Min(Mesh!.TriangleCount, number - Dropped.Count(d => d < number)));
    }
}

/// <summary>One model part of a 3MF package.</summary>
internal sealed class ThreeMfModel
{
    /// <summary>mm per unit.</summary>
    public double Unit { get; set; } = 1;

    public Dictionary<int, ThreeMfObject> Objects { get; } = [];

    public List<ThreeMfUse> Items { get; } = [];
}
