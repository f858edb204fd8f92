using System;
using System.Diagnostics;
using System.Linq;
using Caterpillar.Geometry;
using NUnit.Framework;

namespace Caterpillar.Tests.Geometry.Meshes;

/// <summary>Closed meshes, damaged at random, written to a file, read again and repaired: layers keep their area.</summary>
[TestFixture]
public class DamagedMeshTests
{
    private static readonly string[] Names =
    [
        "fandisk.stl", "spot.obj", "cheburashka.ply", "homer.stl", "plate_holes.stl", "torus.obj", "nested_boxes.obj", "overlap_boxes.stl", "tube_thin.stl",
    ];

    // The tip of a horn is cut off: nothing is left that could tell where it was. Its own test says what is kept.
    private const int TipCutOff = 37;

    [Test]
    public void Layers_of_damaged_meshes_keep_their_area([Values(0, 3, 6, 7, 8, 13, 14, 23, 79, 123, 186, 412, 1080)] int seed) => Check(seed, 1.0);

    [Test, Explicit("Takes half a minute.")]
    public void Layers_of_five_hundred_damaged_meshes_keep_their_area()
    {
        for (var seed = 0; seed < 500; seed++)
        {
            var time = Stopwatch.StartNew();
            if (seed != TipCutOff) Check(seed, 0.3);
            Assert.That(time.Elapsed.TotalSeconds, Is.LessThan(20), $"seed {seed}");
        }
    }

    [Test]
    public void A_tip_that_is_cut_off_loses_only_layers_above_the_rim_of_its_hole()
    {
        var good = TestData.Mesh(TestData.Shared("meshes/" + Names[TipCutOff % Names.Length]));
        var read = MeshReader.Read(StlWriter.ToBytes(MeshDamage.Damage(good, TipCutOff).Mesh), "damaged.stl").Value!;
        var repaired = MeshRepair.ToSolid(TriMesh.Merge(read.Select(m => m.Mesh)));
        var heights = Enumerable.Range(0, (int)(good.Bounds.Max.Z / 0.2)).Select(i => (i + 0.5) * 0.2).ToArray();
        var expected = MeshSections.At(good, heights).Value!.Select(s => ContourMeasure.NonZero(s.Loops).Area).ToArray();
        var areas = MeshSections.At(repaired.Mesh, heights, new SectionOptions { GapMm = 10 }).Value!.Select(s
            => ContourMeasure.NonZero(s.Loops).Area).ToArray();
        var lost = Enumerable.Range(0, heights.Length).Where(i => areas[i] < 0.9 * expected[i]).ToArray();
        Assert.That(lost, Is.Not.Empty, "else the seed belongs to the others");
        Assert.That(repaired.Mesh.IsWatertight);
        var rim = repaired.Holes.Where(h => h.Box.Max.Z > heights[lost[0]]).Min(h => h.Box.Min.Z);
        Assert.That(heights[lost[0]], Is.GreaterThan(rim));
        Assert.That(lost.Sum(i => 0.2 * (expected[i] - areas[i])), Is.LessThan(0.001 * good.Volume));
    }

    private static void Check(int seed, double every)
    {
        var good = TestData.Mesh(TestData.Shared("meshes/" + Names[seed % Names.Length]));
        var (damaged, what) = MeshDamage.Damage(good, seed);
        var read = MeshReader.Read(StlWriter.ToBytes(damaged), "damaged.stl").Value!;
        var repaired = MeshRepair.ToSolid(TriMesh.Merge(read.Select(m => m.Mesh))).Mesh;
        var heights = Enumerable.Range(0, (int)(good.Bounds.Max.Z / every)).Select(i => (i + 0.5) * every).ToArray();
        var expected = MeshSections.At(good, heights).Value!;
        var sections = MeshSections.At(repaired, heights, new SectionOptions { GapMm = 10 }).Value!;
        for (var i = 0; i < heights.Length; i++)
        {
            var area = ContourMeasure.NonZero(expected[i].Loops).Area;
            Assert.That(ContourMeasure.NonZero(sections[i].Loops).Area, Is.GreaterThanOrEqualTo(0.9 * area), $"{what} at z {heights[i]}");
        }
    }
}
