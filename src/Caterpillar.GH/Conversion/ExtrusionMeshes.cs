namespace Caterpillar.GH.Conversion;

/// <summary>Extrusions as Rhino meshes.</summary>
internal static class ExtrusionMeshes
{
    /// <summary>One mesh, with a color for each vertex by its move if colors are given. Null without extrusions.</summary>
    public static Rg.Mesh? ToMesh(ExtrusionMesh extrusions, DocumentUnits units, Func<int, Color>? colorOfMove)
    {
        if (extrusions.Quads.Count == 0) return null;
        var mesh = new Rg.Mesh();
        mesh.Vertices.AddVertices(extrusions.Vertices.Select(v => RhinoGeometry.ToPoint(v, units)));
        var faces = new Rg.MeshFace[extrusions.Quads.Count / 4];
        for (var i = 0; i < faces.Length; i++)
            faces[i] = new Rg.MeshFace(extrusions.Quads[4 * i], extrusions.Quads[4 * i + 1], extrusions.Quads[4 * i + 2], extrusions.Quads[4 * i + 3]);
        mesh.Faces.AddFaces(faces);
        if (colorOfMove is not null) mesh.VertexColors.SetColors(extrusions.Moves.Take(extrusions.Vertices.Count).Select(colorOfMove).ToArray());
        mesh.Normals.ComputeNormals();
        return mesh;
    }
}
