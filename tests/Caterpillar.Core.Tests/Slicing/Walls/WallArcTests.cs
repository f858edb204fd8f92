using System;
using System.IO;
using System.Linq;
using System.Text;
using Caterpillar.Basics;
using Caterpillar.Checks;
using Caterpillar.GCode;
using Caterpillar.Geometry;
using Caterpillar.Machines;
using Caterpillar.Planning;
using Caterpillar.Slicing;
using Caterpillar.Toolpaths;
using NUnit.Framework;

namespace Caterpillar.Tests.Slicing;

/// <summary>Walls of planar layers as arcs.</summary>
public sealed class WallArcTests
{
    private static readonly PrintSettings Plain = new() { WallCount = 2, SkirtLoops = 0 };
    private static readonly PrintSettings Arcs = Plain with { ArcFittingTolerance = 0.02 };
    private static readonly TriMesh Disk = Solids.Cone(0, 10, 2, 10, 192);

    private static PrintPath[] Walls(PrintSettings settings, params TriMesh[] meshes)
        => Solids.Slice(settings, meshes).SelectMany(l => Solids.Paths(l, Role.OuterWall, Role.InnerWall)).ToArray();

    [Test]
    public void Round_walls_are_few_arcs_that_stay_within_the_tolerance([Values(SeamPosition.Nearest, SeamPosition.Aligned)] SeamPosition seam)
    {
        var straight = Walls(Plain with { SeamPosition = seam }, Disk);
        var walls = Walls(Arcs with { SeamPosition = seam }, Disk);

        Assert.That(walls, Has.Length.EqualTo(straight.Length).And.Length.EqualTo(20));
        for (var i = 0; i < walls.Length; i++)
        {
            var wall = walls[i];
            var radius = straight[i].Start.LengthXY;
            Assert.That(wall.HasArcs);
            Assert.That(wall.SegmentCount, Is.LessThanOrEqualTo(6));
            Assert.That(wall.Start, Is.EqualTo(straight[i].Start), "the seam stays");
            Assert.That(PathArcs.Expand(wall, 0.001).RawPoints.Max(p => Math.Abs(p.LengthXY - radius)), Is.LessThan(0.04));
            Assert.That(wall.Volume, Is.EqualTo(straight[i].Volume).Within(0.1).Percent);
        }
    }

    [Test]
    public void Straight_walls_and_fillings_stay_as_they_are()
    {
        var block = Solids.Block(0, 0, 0, 20, 20, 1);

        Assert.That(Walls(Arcs, block).Select(w => w.HasArcs), Has.None.True);
        Assert.That(Solids.Slice(Arcs, Disk).SelectMany(l => Solids.Paths(l, Role.Infill, Role.TopSurface, Role.BottomSurface)).Select(p => p.HasArcs),
            Is.Not.Empty.And.None.True);
    }

    [Test]
    public void Nothing_changes_without_a_tolerance() => Assert.That(Walls(Plain, Disk).Select(w => w.HasArcs), Is.Not.Empty.And.None.True);

    [Test]
    public void A_vase_has_none()
        => Assert.That(Solids.Slice(Arcs with { SpiralVase = true }, Disk).SelectMany(l => l.Steps).Count(s => s.Path.HasArcs && s.Path.Layer!.Index > 3),
            Is.Zero);

    [Test]
    public void Each_model_has_its_own_tolerance()
    {
        var models = new[]
        {
            new SliceModel(new NamedMesh("arcs", Disk), Arcs),
            new SliceModel(new NamedMesh("chords", Disk.Moved(new Vec3(40, 0, 0))), Plain),
        };
        var walls = PlanarSlicer.SliceEach(models, Plain).Value!.Layers.SelectMany(l => Solids.Paths(l, Role.OuterWall)).ToArray();

        Assert.That(walls, Has.Length.EqualTo(20));
        Assert.That(walls.Select(w => w.HasArcs), Is.EqualTo(walls.Select(w => w.Start.X < 20)));
    }

    [Test]
    public void The_file_has_G2_or_G3_and_reads_back_as_what_was_planned()
    {
        var setup = new PrintSetup { Settings = Arcs };
        var plan = Planner.Plan(PlanarSlicer.Slice([new NamedMesh("disk", Disk.Moved(new Vec3(110, 110)))], Arcs).Value!.ToSteps(), setup).Value!;
        using var memory = new MemoryStream();
        var written = SafeWriter.Write(plan, setup, memory);
        var read = GCodeDecoder.Decode(GCodeDocument.FromBytes(memory.ToArray(), "disk")).Value!.Toolpath;

        Assert.That(written.Diagnostics.Where(d => d.Severity == Severity.Error), Is.Empty);
        Assert.That(Encoding.ASCII.GetString(memory.ToArray()), Does.Match("(?m)^G[23] "));
        Assert.That(ExtrusionTotals.Of(read).Length, Is.EqualTo(ExtrusionTotals.Of(plan).Length).Within(0.01).Percent);
    }
}
