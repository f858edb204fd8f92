namespace Caterpillar.GH.Conversion;

/// <summary>The turtle's triangle as Rhino geometry.</summary>
internal static class TurtleShape
{
    /// <summary>A closed outline. Size in mm.</summary>
    public static Rg.PolylineCurve Outline(Frame pose, double size, DocumentUnits units)
    {
        var points = Turtle.TriangleOf(pose, size).Select(p => RhinoGeometry.ToPoint(p, units)).ToList();
        points.Add(points[0]);
        return new Rg.PolylineCurve(points);
    }

    /// <summary>A mesh of one face. Size in mm.</summary>
    public static Rg.Mesh Face(Frame pose, double size, DocumentUnits units)
    {
        var mesh = new Rg.Mesh();
        foreach (var corner in Turtle.TriangleOf(pose, size).Select(p => RhinoGeometry.ToPoint(p, units))) mesh.Vertices.Add(corner.X, corner.Y, corner.Z);
        mesh.Faces.AddFace(0, 1, 2);
        return mesh;
    }
}
