using System.Linq;

namespace Caterpillar.GH.Tests.Host;

/// <summary>Small geometry for tests.</summary>
internal static class Shapes
{
    /// <summary>A closed box of quadrilaterals on the bed, each with corners of its own.</summary>
    public static Rg.Mesh Box(double x = 100, double y = 100, double size = 10, double height = 2)
    {
        var c = new Rg.BoundingBox(x, y, 0, x + size, y + size, height).GetCorners();
        var mesh = new Rg.Mesh();
        mesh.Vertices.UseDoublePrecisionVertices = true;
        foreach (var q in new[] { "0321", "4567", "0154", "1265", "2376", "3047" })
        {
            var first = mesh.Vertices.Count;
            mesh.Vertices.AddVertices(q.Select(i => c[i - '0']));
            mesh.Faces.AddFace(first, first + 1, first + 2, first + 3);
        }
        return mesh;
    }

    public static Rg.Brep Solid(double x = 100, double y = 100, double size = 10, double height = 2)
        => Rg.Brep.CreateFromBox(new Rg.BoundingBox(x, y, 0, x + size, y + size, height));

    /// <summary>A box without its top.</summary>
    public static Rg.Mesh OpenBox()
    {
        var closed = Box();
        var open = new Rg.Mesh();
        open.Vertices.AddVertices(closed.Vertices.ToPoint3dArray());
        for (var i = 0; i < closed.Faces.Count; i++)
        {
            if (i != 1) open.Faces.AddFace(closed.Faces[i]);
        }
        return open;
    }
}
