using System.Linq;
using Caterpillar.Basics;
using Caterpillar.Geometry;
using Caterpillar.Slicing;
using Caterpillar.Tests.Geometry.Meshes;
using NUnit.Framework;

namespace Caterpillar.Tests.Slicing;

/// <summary>The face of a model that goes down, and how it gets there.</summary>
[Category("Arithmetic")]
public class LayFlatTests
{
    private static readonly TriMesh Box = MeshMaker.Box(0, 0, 0, 10, 20, 30);

    private static void Same(Vec3 a, Vec3 b) => Assert.That(a.DistanceTo(b), Is.LessThan(1e-9), $"{a} is not {b}.");

    // A direction of the model goes down by the least turn.
    private static void GoesDown(TriMesh mesh, Vec3 face)
    {
        var turn = LayFlat.Turn(mesh);
        Same(turn.ApplyDirection(face), -Vec3.UnitZ);
        var (x, y, z) = (turn.ApplyDirection(Vec3.UnitX), turn.ApplyDirection(Vec3.UnitY), turn.ApplyDirection(Vec3.UnitZ));
        Same(Vec3.Cross(x, y), z);
        Assert.That((x.Length, y.Length, Vec3.Dot(x, y)), Is.EqualTo((1.0, 1.0, 0.0)).Within(1e-12), "It is not bent.");
        // The trace of a turn tells its angle; the least one turns as far as the face is away from down.
        Assert.That((x.X + y.Y + z.Z - 1) / 2, Is.EqualTo(-face.Z).Within(1e-12));
    }

    // Both faces of 20 × 30 mm are equally large: the one that looks down.
    [TestCase(0, 30, 0, 1)]
    [TestCase(0, -30, 0, -1)]
    [TestCase(10, 50, 20, 1)]
    [TestCase(200, -3, 70, -1)]
    public void The_largest_face_goes_down_and_of_equal_ones_the_nearest(double x, double y, double z, int side)
    {
        var turned = Affine.Rotate(Vec3.UnitX, x).Then(Affine.Rotate(Vec3.UnitY, y)).Then(Affine.Rotate(Vec3.UnitZ, z));
        GoesDown(Box.Transformed(turned), turned.ApplyDirection(Vec3.UnitX * side));
    }

    [Test]
    public void What_lies_on_its_largest_face_stays_and_what_stands_on_its_head_is_turned_about_X()
    {
        Assert.That(LayFlat.Turn(Solids.Cone(0, 8, 5, 3)), Is.EqualTo(Affine.Identity));
        var turn = LayFlat.Turn(Solids.Cone(0, 3, 5, 8));
        Same(turn.Apply(new Vec3(1, 2, 3)), new Vec3(1, -2, -3));
    }

    [Test]
    public void A_tetrahedron_lies_on_its_largest_face()
    {
        Vec3[] corners = [Vec3.Zero, new Vec3(10, 0), new Vec3(0, 10), new Vec3(0, 0, 10)];
        GoesDown(TriMesh.Create(corners, [0, 2, 1, 0, 1, 3, 1, 2, 3, 2, 0, 3]), new Vec3(1, 1, 1).Unit());
    }

    [Test]
    public void Many_triangles_of_one_face_count_together_and_those_around_a_cylinder_do_not()
    {
        // The end has 78 mm², each of 48 strips 4 mm², all of them 188 mm².
        var lying = Affine.Rotate(Vec3.UnitX, 90);
        GoesDown(Solids.Cone(0, 5, 6, 5, 48).Transformed(lying), Vec3.UnitY);
    }

    // Two faces 100 mm wide beside each other, and one of 150 mm on the other side: together they are larger if they are one face.
    [TestCase(0.02, true)]
    [TestCase(0.2, false)]
    [TestCase(1.2, false)]
    public void Faces_that_are_almost_in_a_plane_are_one(double degrees, bool isOne)
    {
        var rise = 100 * Angle.Sin(degrees) / Angle.Cos(degrees);
        Vec3[] profile = [new(-100, 0, rise), new(0, 0, 0), new(100, 0, rise), new(75, 0, 50), new(-75, 0, 50)];
        Vec3[] points = [.. profile, .. profile.Select(p => p + 400 * Vec3.UnitY)];
        // The sides are enough: what counts is the hull.
        int[] sides = [.. Enumerable.Range(0, 5).SelectMany(i => new[] { i, (i + 1) % 5, i + 5, (i + 1) % 5, (i + 1) % 5 + 5, i + 5 })];
        GoesDown(TriMesh.Create(points, sides), isOne ? -Vec3.UnitZ : Vec3.UnitZ);
    }

    [Test]
    public void What_has_no_volume_stays()
        => Assert.That(LayFlat.Turn(TriMesh.Create([new(0, 0, 0), new(1, 0, 0), new(0, 2, 0)], [0, 1, 2])), Is.EqualTo(Affine.Identity));
}
