using System;
using System.Collections.Generic;
using Caterpillar.Geometry;
using Caterpillar.GH.Base;
using Caterpillar.GH.Conversion;
using NUnit.Framework;

namespace Caterpillar.GH.Tests.Host;

/// <summary>Everything that can be sliced as triangles. On the real RhinoCommon some shapes need native code that only Rhino has: those are skipped.</summary>
[Category("Host")]
public sealed class ModelKindTests
{
    private static readonly Rg.BoundingBox Cube = new(10, 10, 0, 30, 30, 20);

    private static readonly Dictionary<string, Func<object>> Models = new()
    {
        ["Mesh"] = () => Shapes.Box(10, 10, 20, 20),
        ["Box"] = () => new Rg.Box(Cube),
        ["Brep"] = () => Rg.Brep.CreateFromBox(Cube),
        ["Extrusion"] = () => Rg.Extrusion.CreateBoxExtrusion(new Rg.Box(Cube)),
        ["SubD"] = () => Rg.SubD.CreateFromMesh(Shapes.Box(10, 10, 20, 20)),
    };

    public static IEnumerable<string> Kinds => Models.Keys;

    [TestCaseSource(nameof(Kinds))]
    public void A_cube_of_any_kind_is_the_same_solid(string kind)
    {
        var mesh = Triangles(Models[kind]);
        Assert.That(mesh.Bounds.Min.DistanceTo(new Vec3(10, 10, 0)), Is.LessThan(1e-6));
        Assert.That(mesh.Bounds.Max.DistanceTo(new Vec3(30, 30, 20)), Is.LessThan(1e-6));
        Assert.That(mesh.NakedEdgeCount, Is.Zero);
        Assert.That(mesh.Volume, Is.EqualTo(8000).Within(1e-3));
    }

    [Test]
    public void An_extrusion_is_a_solid_as_a_Brep()
    {
        var brep = Rg.Extrusion.CreateBoxExtrusion(new Rg.Box(Cube)).ToBrep(false);
        Assert.That((brep.IsValid, brep.IsSolid), Is.EqualTo((true, true)));
    }

    [Test]
    public void A_plane_surface_is_a_sheet_with_open_edges()
    {
        var mesh = Triangles(() => new Rg.PlaneSurface(Rg.Plane.WorldXY, new Rg.Interval(0, 20), new Rg.Interval(0, 10)));
        Assert.That(mesh.NakedEdgeCount, Is.GreaterThan(0));
        Assert.That(mesh.Bounds.Size.DistanceTo(new Vec3(20, 10, 0)), Is.LessThan(1e-9));
    }

    private static TriMesh Triangles(Func<object> make)
    {
        try
        {
            return RhinoMesh.ToTriangles(RhinoMesh.ToMesh(make(), 0.05, DocumentUnits.Current), DocumentUnits.Current);
        }
        catch (EntryPointNotFoundException missing)
        {
            Assert.Ignore("Only Rhino has the native code for this: " + missing.Message);
            throw;
        }
        catch (InputProblem) when (typeof(Rg.Mesh).Assembly.GetName().GetPublicKeyToken() is { Length: > 0 })
        {
            Assert.Ignore("Only Rhino meshes every Brep; the native library of the tests meshes some boxes.");
            throw;
        }
    }
}
