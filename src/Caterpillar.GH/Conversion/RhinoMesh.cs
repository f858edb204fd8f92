namespace Caterpillar.GH.Conversion;

/// <summary>Turns any geometry that has a surface into triangles in mm.</summary>
internal static class RhinoMesh
{
    /// <summary>One Rhino mesh for anything that can be sliced. The tolerance, in mm, is the maximum deviation of facets from a curved surface.</summary>
    /// <exception cref="InputProblem">It has no surface, or Rhino can't mesh it.</exception>
    public static Rg.Mesh ToMesh(object geometry, double tolerance, DocumentUnits units)
    {
        var parameters = new Rg.MeshingParameters
        {
            Tolerance = tolerance * units.FromMillimeters,
            MinimumEdgeLength = tolerance * units.FromMillimeters / 10,
            RefineGrid = true,
            JaggedSeams = false,
            SimplePlanes = true,
        };
        return geometry switch
        {
            Rg.Mesh mesh => mesh,
            Rg.Box box => FromBox(box),
            Rg.Brep brep => Joined(Rg.Mesh.CreateFromBrep(brep, parameters)),
            Rg.Extrusion extrusion => Joined(Rg.Mesh.CreateFromBrep(extrusion.ToBrep(false), parameters)),
            Rg.Surface surface => Joined([Rg.Mesh.CreateFromSurface(surface, parameters)]),
            Rg.SubD subd => Joined([Rg.Mesh.CreateFromSubD(subd, 4)]),
            _ => throw new InputProblem($"A {geometry.GetType().Name} cannot be sliced. Use a mesh, box, Brep, SubD, extrusion or surface."),
        };
    }

    /// <summary>The triangles of a mesh. Quadrilaterals are split along their shorter diagonal. Document units become mm.</summary>
    /// <remarks>A face with two corners at one place makes a mesh invalid for Rhino. Here it is harmless, and the library drops it.</remarks>
    /// <exception cref="InputProblem">The mesh is empty, a face refers to no vertex, or a vertex is not finite.</exception>
    public static TriMesh ToTriangles(Rg.Mesh mesh, DocumentUnits units)
    {
        if (mesh.Faces.Count == 0) throw new InputProblem("A mesh has no faces.");
        var points = mesh.Vertices.ToPoint3dArray();
        var vertices = new Vec3[points.Length];
        for (var i = 0; i < points.Length; i++)
        {
            if (!points[i].IsValid) throw new InputProblem($"Vertex {NumberFormatter.Format(i)} of a mesh is not finite.");
            vertices[i] = RhinoGeometry.ToVec(points[i], units);
        }
        var triangles = new List<int>(3 * mesh.Faces.Count);
        for (var i = 0; i < mesh.Faces.Count; i++)
        {
            var f = mesh.Faces[i];
            if (Math.Min(Math.Min(f.A, f.B), Math.Min(f.C, f.D)) < 0 || Math.Max(Math.Max(f.A, f.B), Math.Max(f.C, f.D)) >= points.Length)
                throw new InputProblem($"Face {NumberFormatter.Format(i)} of a mesh refers to a vertex that does not exist.");
            if (f.IsTriangle)
            {
                triangles.AddRange([f.A, f.B, f.C]);
            }
            else if ((vertices[f.A] - vertices[f.C]).LengthSquared <= (vertices[f.B] - vertices[f.D]).LengthSquared)
            {
                triangles.AddRange([f.A, f.B, f.C, f.A, f.C, f.D]);
            }
            else
            {
                triangles.AddRange([f.A, f.B, f.D, f.B, f.C, f.D]);
            }
        }
        return TriMesh.Create(vertices, triangles);
    }

    /// <summary>A mesh of triangles in mm as one of Rhino in document units.</summary>
    public static Rg.Mesh FromTriangles(TriMesh triangles, DocumentUnits units)
    {
        var mesh = new Rg.Mesh();
        mesh.Vertices.UseDoublePrecisionVertices = true;
        mesh.Vertices.AddVertices(triangles.Vertices.Select(v => RhinoGeometry.ToPoint(v, units)));
        var faces = new Rg.MeshFace[triangles.TriangleCount];
        for (var i = 0; i < faces.Length; i++)
            faces[i] = new Rg.MeshFace(triangles.Indices[3 * i], triangles.Indices[3 * i + 1], triangles.Indices[3 * i + 2]);
        mesh.Faces.AddFaces(faces);
        return mesh;
    }

    private static Rg.Mesh FromBox(Rg.Box box)
    {
        box.MakeValid();
        if (!box.IsValid) throw new InputProblem("A box is not valid.");
        var mesh = new Rg.Mesh();
        mesh.Vertices.UseDoublePrecisionVertices = true;
        mesh.Vertices.AddVertices(box.GetCorners());
        mesh.Faces.AddFace(0, 3, 2, 1);
        mesh.Faces.AddFace(4, 5, 6, 7);
        mesh.Faces.AddFace(0, 1, 5, 4);
        mesh.Faces.AddFace(1, 2, 6, 5);
        mesh.Faces.AddFace(2, 3, 7, 6);
        mesh.Faces.AddFace(3, 0, 4, 7);
        return mesh;
    }

    private static Rg.Mesh Joined(Rg.Mesh?[]? parts)
    {
        if (parts is null || parts.Contains(null)) throw new InputProblem("Rhino could not mesh the geometry.");
        var joined = new Rg.Mesh();
        foreach (var part in parts) joined.Append(part);
        return joined;
    }
}
