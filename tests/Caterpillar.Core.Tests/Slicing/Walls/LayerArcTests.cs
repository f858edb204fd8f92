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

/// <summary>Paths of planar layers as arcs.</summary>
public sealed class LayerArcTests
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
        var paths = Solids.Slice(Arcs, Solids.Block(0, 0, 0, 20, 20, 2)).SelectMany(l => Solids.Paths(l));
        Assert.That(paths.Select(p => p.HasArcs), Is.Not.Empty.And.None.True);
    }

    private static PrintPath[] Infill(PrintSettings settings, InfillPattern pattern)
        => [.. Solids.Slice(settings with { InfillPattern = pattern }, Solids.Cone(0, 10, 4, 10, 192)).SelectMany(l => Solids.Paths(l, Role.Infill))];

    [Test]
    public void The_waves_of_a_gyroid_are_arcs()
    {
        var (straight, arcs) = (Infill(Plain, InfillPattern.Gyroid), Infill(Arcs, InfillPattern.Gyroid));
        int Moves(PrintPath[] paths) => paths.Sum(p => p.SegmentCount);
        Assert.That(Moves(arcs), Is.LessThan(0.7 * Moves(straight)));
        Assert.That(arcs.Sum(p => p.Volume), Is.EqualTo(straight.Sum(p => p.Volume)).Within(0.7).Percent);
    }

    [TestCase(InfillPattern.Concentric)]
    [TestCase(InfillPattern.Lines)]
    public void Round_infill_becomes_arcs_and_keeps_its_course_and_volume(InfillPattern pattern)
    {
        var (straight, arcs) = (Infill(Plain, pattern), Infill(Arcs, pattern));

        Assert.That(arcs, Has.Length.EqualTo(straight.Length));
        Assert.That(arcs.Count(p => p.HasArcs), Is.GreaterThan(0));
        Assert.That(arcs.Sum(p => p.SegmentCount), Is.LessThan((pattern == InfillPattern.Lines ? 1 : 0.5) * straight.Sum(p => p.SegmentCount)));
        for (var i = 0; i < arcs.Length; i++)
        {
            Assert.That(arcs[i].Volume, Is.EqualTo(straight[i].Volume).Within(0.5).Percent);
            foreach (var p in PathArcs.Expand(arcs[i], 0.001).RawPoints)
                Assert.That((LoopPlace.Nearest(straight[i].RawPoints, p).Point - p).LengthXY, Is.LessThan(0.025));
        }
    }

    [Test]
    public void Skirt_brim_and_supports_have_the_arcs_of_the_print()
    {
        var around = Arcs with { SkirtLoops = 1, BrimWidth = 2 };
        var supported = around with { Support = SupportKind.Grid };
        var mushroom = TriMesh.Merge([Solids.Cone(0, 5, 4, 5, 96), Solids.Cone(4, 12, 5, 12, 96)]);
        bool[] HaveArcs(PrintSettings common, Role role)
        {
            var model = new SliceModel(new NamedMesh("m", mushroom), supported with { Support = common.Support });
            return [.. PlanarSlicer.SliceEach([model], common).Value!.Layers.SelectMany(l => Solids.Paths(l, role)).Select(p => p.HasArcs)];
        }

        Assert.That(HaveArcs(around, Role.Skirt), Is.Not.Empty.And.All.True);
        Assert.That(HaveArcs(around, Role.Brim), Is.Not.Empty.And.All.True);
        Assert.That(HaveArcs(supported, Role.Support), Has.Some.True);
        Assert.That(HaveArcs(around with { ArcFittingTolerance = 0 }, Role.Skirt), Is.Not.Empty.And.None.True);
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

        Assert.That(written.Diagnostics.Where(d => d.Severity >= Severity.Warning), Is.Empty);
        Assert.That(Encoding.ASCII.GetString(memory.ToArray()), Does.Match("(?m)^G[23] "));
        Assert.That(ToolpathTotals.Of(read).PrintLength, Is.EqualTo(ToolpathTotals.Of(plan).PrintLength).Within(0.01).Percent);
    }
}
