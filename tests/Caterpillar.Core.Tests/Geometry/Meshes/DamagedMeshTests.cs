using System;
using System.Diagnostics;
using System.Linq;
using Caterpillar.Geometry;
using NUnit.Framework;

namespace Caterpillar.Tests.Geometry.Meshes;

/// <summary>Closed meshes, damaged at random, written to a file, read again and mended: layers keep their area.</summary>
[TestFixture]
public class DamagedMeshTests
{
    private static readonly string[] Names =
    [
        "fandisk.stl", "spot.obj", "cheburashka.ply", "homer.stl", "plate_holes.stl", "torus.obj", "nested_boxes.obj", "overlap_boxes.stl", "tube_thin.stl",
    ];

    // The tip of a horn is cut off: nothing is left that could tell where it was.
    private const int TipCutOff = 37;

    [Test]
    public void Layers_of_damaged_meshes_keep_their_area([Values(0, 3, 6, 7, 8, 13, 14, 23, 79, 123, 186, 412)] int seed) => Check(seed, 1.0);

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

    private static void Check(int seed, double every)
    {
        var good = MeshReader.ReadMerged(TestData.Shared("meshes/" + Names[seed % Names.Length])).Value!;
        var (damaged, what) = MeshDamage.Damage(good, seed);
        var read = MeshReader.Read(StlWriter.ToBytes(damaged), "damaged.stl").Value!;
        var mended = MeshRepair.ToSolid(TriMesh.Merge(read.Select(m => m.Mesh))).Mesh;
        var heights = Enumerable.Range(0, (int)(good.Bounds.Max.Z / every)).Select(i => (i + 0.5) * every).ToArray();
        var expected = MeshSections.At(good, heights).Value!;
        var sections = MeshSections.At(mended, heights, new SectionOptions { GapMm = 10 }).Value!;
        for (var i = 0; i < heights.Length; i++)
        {
            var area = ContourMeasure.NonZero(expected[i].Loops).Area;
            Assert.That(ContourMeasure.NonZero(sections[i].Loops).Area, Is.GreaterThanOrEqualTo(0.9 * area), $"{what} at z {heights[i]}");
        }
    }
}
