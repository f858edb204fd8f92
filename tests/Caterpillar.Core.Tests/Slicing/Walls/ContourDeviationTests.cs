using System.Linq;
using Caterpillar.Geometry;
using Caterpillar.Machines;
using NUnit.Framework;

namespace Caterpillar.Tests.Slicing;

public class ContourDeviationTests
{
    [TestCase("plate_holes.stl", 6)]
    [TestCase("torus.obj", 10)]
    [TestCase("spot.obj", 40)]
    public void Outer_walls_follow_the_exact_section_over_all_but_a_thousandth_of_their_length(string name, int every)
    {
        var deviation = ContourDeviation.Of(Mesh(name), new PrintSettings(), every);
        Assert.That(deviation.Length, Is.GreaterThan(500));
        Assert.That(deviation.SharePercent, Is.LessThan(0.1), $"of {deviation.Length} mm, at most {deviation.Largest} mm off");
    }

    [Test]
    public void A_part_that_is_moved_outward_is_found_to_deviate()
    {
        var deviation = ContourDeviation.Of(Mesh("plate_holes.stl"), new PrintSettings { XySizeCompensation = 0.02 }, 6);
        Assert.That(deviation.SharePercent, Is.GreaterThan(99));
        Assert.That(deviation.Largest, Is.EqualTo(0.02).Within(0.0126));
    }

    [Test]
    public void A_coarser_tolerance_is_seen()
    {
        var mesh = Mesh("torus.obj");
        var fine = ContourDeviation.Of(mesh, new PrintSettings { Resolution = 0.001 }, 20);
        var coarse = ContourDeviation.Of(mesh, new PrintSettings { Resolution = 0.05 }, 20);
        Assert.That(fine.Largest, Is.LessThan(0.005));
        Assert.That(coarse.SharePercent, Is.GreaterThan(5));
    }

    private static TriMesh Mesh(string name) => TriMesh.Merge(MeshReader.Read(TestData.Shared("meshes/" + name)).Value!.Select(m => m.Mesh).ToArray());
}
