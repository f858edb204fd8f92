using System.Drawing;
using Caterpillar.Display;

namespace Caterpillar.GH.Conversion;

/// <summary>Strands as Rhino meshes.</summary>
internal static class StrandMeshes
{
    /// <summary>One mesh, with a color for each vertex by its move if colors are given; null without strands.</summary>
    public static Rg.Mesh? ToMesh(StrandMesh strands, DocumentUnits units, Func<int, Color>? colorOfMove)
    {
        if (strands.Quads.Count == 0) return null;
        var mesh = new Rg.Mesh();
        var points = new Rg.Point3d[strands.Vertices.Count];
        for (var i = 0; i < points.Length; i++) points[i] = RhinoGeometry.ToPoint(strands.Vertices[i], units);
        mesh.Vertices.AddVertices(points);
        var faces = new Rg.MeshFace[strands.Quads.Count / 4];
        for (var i = 0; i < faces.Length; i++)
            faces[i] = new Rg.MeshFace(strands.Quads[4 * i], strands.Quads[4 * i + 1], strands.Quads[4 * i + 2], strands.Quads[4 * i + 3]);
        mesh.Faces.AddFaces(faces);
        if (colorOfMove is not null)
        {
            var colors = new Color[points.Length];
            for (var i = 0; i < colors.Length; i++) colors[i] = colorOfMove(strands.Moves[i]);
            mesh.VertexColors.SetColors(colors);
        }
        mesh.Normals.ComputeNormals();
        return mesh;
    }
}
