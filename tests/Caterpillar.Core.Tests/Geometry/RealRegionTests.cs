using System.Collections.Generic;
using System.Linq;
using Caterpillar.Geometry;
using NetTopologySuite.Operation.Buffer;
using NUnit.Framework;
using JoinStyle = Caterpillar.Geometry.JoinStyle;

namespace Caterpillar.Tests.Geometry;

/// <summary>Regions of plane sections of the shared meshes against NetTopologySuite.</summary>
public class RealRegionTests
{
    private static IReadOnlyList<Section> Sections(string file, params double[] shares)
    {
        var mesh = TestData.Mesh(TestData.Shared("meshes/" + file));
        var (low, height) = (mesh.Bounds.Min.Z, mesh.Bounds.Size.Z);
        return MeshSections.At(mesh, shares.Select(s => low + s * height).ToArray()).Value!;
    }

    [TestCase("fandisk.stl")]
    [TestCase("spot.obj")]
    [TestCase("cheburashka.ply")]
    [TestCase("homer.stl")]
    [TestCase("plate_holes.stl")]
    [TestCase("torus.obj")]
    [TestCase("overlap_boxes.stl")]
    [TestCase("tube_thin.stl")]
    [TestCase("ogre_bodies.ply")]
    public void Sections_of_meshes_and_their_offsets_agree_with_NetTopologySuite(string file)
    {
        foreach (var section in Sections(file, 0.033, 0.21, 0.52, 0.77, 0.951))
        {
            var region = Region.From(section.Loops);
            RegionReference.AssertValid(region);
            var (area, perimeter, _, _) = ContourMeasure.NonZero(section.Loops);
            Assert.That(region.Area, Is.EqualTo(area).Within(1e-5 * (perimeter + 1)));
            Assert.That(region.Perimeter, Is.EqualTo(perimeter).Within(1e-4 * (perimeter + 1)));
            var nts = RegionReference.ToNts(region);
            Assert.That(nts.IsValid, $"{file} at {section.Z}");
            foreach (var d in new[] { -0.2, -0.85, 0.4, 3 })
            {
                var ours = region.Offset(d, JoinStyle.Round, 2, 0.0005);
                RegionReference.AssertValid(ours);
                var theirs = BufferOp.Buffer(nts, d, new BufferParameters(64) { SimplifyFactor = 0.0001 });
                Assert.That(ours.Area, Is.EqualTo(theirs.Area).Within(1e-3 * (1 + theirs.Length)), $"{file} at {section.Z} by {d}");
                Assert.That(ours.Islands.Count(i => i.Area > 1e-3), Is.EqualTo(CountOver(theirs, 1e-3)), $"{file} at {section.Z} by {d}");
            }
        }
    }

    [TestCase("fandisk.stl")]
    [TestCase("plate_holes.stl")]
    [TestCase("spot.obj")]
    public void Walls_of_a_section_lie_within_each_other_and_hatch_fills_what_is_left(string file)
    {
        foreach (var section in Sections(file, 0.11, 0.6))
        {
            var outline = Region.From(section.Loops).Simplified(0.0125);
            var first = outline.Offset(-0.2);
            var second = first.Offset(-0.4);
            Assert.That(first.Subtract(outline).IsEmpty && second.Subtract(first).IsEmpty);
            var rest = second.Offset(-0.2);
            var hatch = rest.HatchLines(45, 0.05).Sum(l => l.From.DistanceTo(l.To)) * 0.05;
            Assert.That(hatch, Is.EqualTo(rest.Area).Within(0.01 * rest.Area + 0.01));
        }
    }

    private static int CountOver(NetTopologySuite.Geometries.Geometry geometry, double area)
        => Enumerable.Range(0, geometry.NumGeometries).Count(i => geometry.GetGeometryN(i).Area > area);
}
