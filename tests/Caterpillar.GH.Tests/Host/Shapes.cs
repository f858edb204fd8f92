using System.Linq;

namespace Caterpillar.GH.Tests.Host;

/// <summary>Small geometry for tests.</summary>
internal static class Shapes
{
    /// <summary>A closed box of quadrilaterals on the bed.</summary>
    public static Rg.Mesh Box(double x = 100, double y = 100, double size = 10, double height = 2)
    {
        var mesh = new Rg.Mesh();
        mesh.Append(Rg.Mesh.CreateFromBrep(Rg.Brep.CreateFromBox(new Rg.BoundingBox(x, y, 0, x + size, y + size, height)), Rg.MeshingParameters.Default)[0]);
        foreach (var part in Rg.Mesh.CreateFromBrep(Solid(x, y, size, height), Rg.MeshingParameters.Default).Skip(1)) mesh.Append(part);
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
