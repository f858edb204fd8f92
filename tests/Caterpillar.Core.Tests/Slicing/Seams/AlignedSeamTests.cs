using System;
using System.Collections.Generic;
using System.Linq;
using Caterpillar.Basics;
using Caterpillar.Geometry;
using Caterpillar.Machines;
using Caterpillar.Slicing;
using Caterpillar.Toolpaths;
using NUnit.Framework;

namespace Caterpillar.Tests.Slicing;

/// <summary>Aligned seams of smooth parts run on from layer to layer, as one thin line.</summary>
public class AlignedSeamTests
{
    private static readonly PrintSettings Plain = new()
    {
        LineWidth = 0.4, LayerHeight = 0.2, TopLayers = 0, BottomLayers = 0, InfillDensityPercent = 0, WallCount = 2, MinLayerTime = 0, SkirtLoops = 0,
        SeamPosition = SeamPosition.Aligned,
    };

    [TestCase("ball", 0)]
    [TestCase("ball", 10)]
    [TestCase("meshes/torus.obj", 0)]
    [TestCase("meshes/torus.obj", 10)]
    [TestCase("meshes/spot.obj", 0)]
    [TestCase("meshes/spot.obj", 10)]
    [TestCase("meshes/homer.stl", 0)]
    [TestCase("meshes/cheburashka.ply", 0)]
    public void Aligned_seams_of_smooth_parts_jump_by_less_than_a_fifth_of_a_millimeter(string name, double scarf)
    {
        var mesh = name == "ball" ? Ball(15) : TestData.Mesh(TestData.Shared(name));
        var seams = Solids.Slice(Plain with { ScarfSeamLength = scarf }, mesh).Select(Seams).ToArray();
        var jumps = new List<double>();
        for (var i = 1; i < seams.Length; i++)
        {
            if (seams[i - 1].Length == 0) continue;
            foreach (var seam in seams[i]) jumps.Add(seams[i - 1].Min(s => s.DistanceTo(seam)));
        }
        Assert.That(jumps, Has.Count.GreaterThan(80));
        jumps.Sort();
        TestContext.Out.WriteLine($"{name} {scarf}: {jumps.Count}, {jumps[jumps.Count / 2]:F3}, {jumps[jumps.Count * 9 / 10]:F3}, {jumps[jumps.Count - 1]:F3}");
        Assert.That(jumps[jumps.Count / 2], Is.LessThan(0.2));
        Assert.That(jumps[jumps.Count * 9 / 10], Is.LessThan(1.5));
    }

    // Loops, and scarfs, which begin low.
    private static Vec3[] Seams(SlicedLayer layer)
        => layer.Steps.Select(s => s.Path).Where(p => p.Role is Role.OuterWall or Role.OverhangWall && (p.IsClosed || p.Start.Z < layer.Layer.Z - 1e-6))
            .Select(p => p.Start.WithZ(0)).ToArray();

    // Of 64 slices; it stands on the bed.
    private static TriMesh Ball(double radius)
    {
        const int Slices = 64;
        (double Z, double R) At(int i)
        {
            var (sin, cos) = Angle.SinCos(180.0 * i / Slices);
            return (radius - radius * cos, Math.Max(0, radius * sin));
        }
        return TriMesh.Merge(Enumerable.Range(0, Slices).Select(i => Solids.Cone(At(i).Z, At(i).R, At(i + 1).Z, At(i + 1).R, 128)));
    }
}
