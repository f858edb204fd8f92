using System.Collections.Generic;
using Caterpillar.Basics;
using Caterpillar.GH.Base;
using Caterpillar.Geometry;

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
            Rg.Brep brep => Joined(Rg.Mesh.CreateFromBrep(brep, parameters)),
            Rg.Extrusion extrusion => Joined(Rg.Mesh.CreateFromBrep(extrusion.ToBrep(false), parameters)),
            Rg.Surface surface => Joined([Rg.Mesh.CreateFromSurface(surface, parameters)]),
            Rg.SubD subd => Joined([Rg.Mesh.CreateFromSubD(subd, 4)]),
            _ => throw new InputProblem($"A {geometry.GetType().Name} has no surface to slice: use a mesh, Brep, SubD, extrusion or surface."),
        };
    }

    /// <summary>The triangles of a mesh; quadrilaterals are split along their shorter diagonal. Document units become mm.</summary>
    /// <exception cref="InputProblem">The mesh is empty or not valid.</exception>
    public static TriMesh ToTriangles(Rg.Mesh mesh, DocumentUnits units)
    {
        if (mesh.Faces.Count == 0) throw new InputProblem("A mesh without faces can't be sliced.");
        if (!mesh.IsValid) throw new InputProblem("A mesh is not valid: Rhino's command Check tells why.");
        var points = mesh.Vertices.ToPoint3dArray();
        var vertices = new Vec3[points.Length];
        for (var i = 0; i < points.Length; i++) vertices[i] = RhinoGeometry.ToVec(points[i], units);
        var triangles = new List<int>(3 * mesh.Faces.Count);
        for (var i = 0; i < mesh.Faces.Count; i++)
        {
            var f = mesh.Faces[i];
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

    /// <summary>The triangles of several meshes as one surface; null for none.</summary>
    /// <exception cref="InputProblem">A mesh is empty or not valid.</exception>
    public static TriMesh? ToTriangles(IReadOnlyList<Rg.Mesh> meshes, DocumentUnits units)
    {
        if (meshes.Count == 0) return null;
        if (meshes.Count == 1) return ToTriangles(meshes[0], units);
        var vertices = new List<Vec3>();
        var triangles = new List<int>();
        foreach (var mesh in meshes)
        {
            var part = ToTriangles(mesh, units);
            var first = vertices.Count;
            vertices.AddRange(part.Vertices);
            foreach (var index in part.Indices) triangles.Add(first + index);
        }
        return TriMesh.Create(vertices, triangles);
    }

    private static Rg.Mesh Joined(Rg.Mesh?[]? parts)
    {
        if (parts is null) throw new InputProblem("Rhino could not mesh the geometry.");
        var joined = new Rg.Mesh();
        foreach (var part in parts)
        {
            if (part is null) throw new InputProblem("Rhino could not mesh the geometry.");
            joined.Append(part);
        }
        return joined;
    }
}
