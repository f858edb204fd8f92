using System;
using System.Collections.Generic;
using System.Linq;
using Caterpillar.Geometry;
using Caterpillar.Machines;
using Caterpillar.Slicing;
using Caterpillar.Toolpaths;
using NUnit.Framework;

namespace Caterpillar.Tests.Slicing;

public class SupportTests
{
    private const double Width = 0.4;

    private static readonly PrintSettings Bare = new()
    {
        LineWidth = Width, BeadShape = BeadShape.Rectangle, TopLayers = 0, BottomLayers = 0, InfillDensityPercent = 0, WallCount = 2, MinLayerTime = 0,
    };

    // A slab at 10 mm, 30 mm wide, on a post of 10 mm.
    private static TriMesh[] Table => [Solids.Block(10, 0, 0, 20, 20, 10.05), Solids.Block(0, 0, 10, 30, 20, 12)];

    // The same over a foot that reaches as far on the left, with a slope.
    private static TriMesh[] Footed => [.. Table, Solids.Loft(
        0, [new(-5, 0), new(11, 0), new(11, 20), new(-5, 20)], 6, [new(9, 0), new(11, 0), new(11, 20), new(9, 20)])];

    private static readonly Role[] Roles = [Role.Support, Role.SupportInterface];

    private static PrintSettings With(SupportKind kind, SupportPlacement place = SupportPlacement.Everywhere)
        => Bare with { Support = kind, SupportPlacement = place };

    private static IEnumerable<TestCaseData> Prints()
    {
        foreach (var kind in new[] { SupportKind.Grid, SupportKind.Tree })
        {
            foreach (var place in new[] { SupportPlacement.Everywhere, SupportPlacement.BuildPlate })
            {
                var mesh = place == SupportPlacement.BuildPlate ? "meshes/torus.obj" : "meshes/spot.obj";
                foreach (var name in new[] { "table", "footed", "cone", mesh }) yield return new TestCaseData(kind, place, name);
            }
        }
    }

    private static TriMesh[] Model(string name) => name switch
    {
        "table" => Table,
        "footed" => Footed,
        "cone" => [Solids.Cone(0, 3, 5, 3), Solids.Cone(4.99, 3, 10, 15)],
        _ => [TestData.Mesh(TestData.Shared(name)).Scaled(0.6)],
    };

    [TestCaseSource(nameof(Prints))]
    public void Supports_keep_their_distance_and_rest_on_something(SupportKind kind, SupportPlacement place, string name)
    {
        var settings = With(kind, place) with { LayerHeight = name.StartsWith("meshes", StringComparison.Ordinal) ? 0.4 : 0.2 };
        var layers = Solids.Slice(settings, Model(name));
        var lengths = 0.0;
        for (var i = 0; i < layers.Count; i++)
        {
            var paths = Solids.Paths(layers[i], Roles);
            if (paths.Length == 0) continue;
            lengths += paths.Sum(p => p.Length);
            foreach (var (half, lines) in ByHalfWidth(paths, settings.BeadShape))
            {
                var near = layers[i].Region.IsEmpty ? Region.Empty : layers[i].Region.Offset(settings.SupportXyGap + half - 0.1, JoinStyle.Round);
                Assert.That(near.ClipLines(lines).Sum(l => l.Length), Is.LessThan(0.1), $"too near to the part at {layers[i].Layer.Z}");
            }
            for (var k = i + 1; k < layers.Count && layers[k].Layer.Z - layers[k].Layer.Thickness < layers[i].Layer.Z + settings.SupportTopGap - 1e-6; k++)
                Assert.That(layers[k].Region.ClipLines(paths.Select(Line)).Sum(l => l.Length), Is.LessThan(0.01), $"touches what is above {layers[i].Layer.Z}");
            if (i == 0) continue;
            // Below lies a support, up to as far aside as it may lean, or the part as near as the gaps leave it.
            var below = layers[i - 1].Support.Offset(settings.LayerHeight + 0.1, JoinStyle.Round);
            // The roof of a tree spans its tips, and leans out by a line beyond what is below.
            var roofed = kind == SupportKind.Tree && layers.Skip(i - settings.SupportInterfaceLayers).Take(2 * settings.SupportInterfaceLayers + 1)
                .Any(l => Solids.Paths(l, Role.SupportInterface).Length > 0);
            if (roofed) below = below.Union(layers[i - 1].Support.Closed(0.75 * settings.TreeTipDistance + Width).Offset(Width + 0.2));
            if (place == SupportPlacement.Everywhere)
            {
                for (var k = i - 1; k >= 0 && layers[k].Layer.Z > layers[i]
                    .Layer.Z - settings.SupportBottomGap - settings.SupportXyGap - 3 * settings.LayerHeight; k--)
                    below = below.Union(layers[k].Region);
            }
            var loose = below.ClipLines(paths.Select(Line), outside: true);
            Assert.That(loose.Sum(l => l.Length), Is.LessThan(0.01), $"hangs in the air at {loose.FirstOrDefault()?[0]}");
        }
        Assert.That(lengths, Is.GreaterThan(50));
    }

    // Segments by half of their width, rounded down to 0.05 mm. Extrusions end at the edge of their place, and are no thinner than a bead can be.
    private static IEnumerable<(double Half, List<Polyline> Lines)> ByHalfWidth(PrintPath[] paths, BeadShape shape)
        => paths.SelectMany(p => Enumerable.Range(0, p.SegmentCount).Select(i => (Path: p, Segment: i)))
            .GroupBy(s => IsEnd(s.Path, s.Segment) ? 0 : Math.Floor(Math.Min(s.Path.BeadOf(s.Segment).Width(shape), Width) / 2 / 0.05 + 1e-6) * 0.05)
            .Select(g => (g.Key, g.Select(s => new Polyline([s.Path.Points[s.Segment], s.Path.EndOf(s.Segment)])).ToList()));

    private static bool IsEnd(PrintPath path, int segment)
    {
        var middle = Vec3.Lerp(path.Points[segment], path.EndOf(segment), 0.5);
        return !path.IsClosed && Math.Min(middle.DistanceTo(path.Start), middle.DistanceTo(path.End)) < Width;
    }

    private static Polyline Line(PrintPath path) => new(path.Points, path.IsClosed);

    [Test]
    public void Without_the_setting_there_are_none()
        => Assert.That(Solids.Slice(Bare, Table).SelectMany(l => Solids.Paths(l, Roles)), Is.Empty);

    [TestCase(SupportKind.Grid)]
    [TestCase(SupportKind.Tree)]
    public void A_slab_is_held_from_below_up_to_the_gap(SupportKind kind)
    {
        var layers = Solids.Slice(With(kind) with { SupportTopGap = 0.3 }, Table);
        var held = layers.Where(l => Solids.Paths(l, Roles).Length > 0).ToArray();
        // The slab begins at 10 mm; layers of 0.2 mm leave 0.4 mm open.
        Assert.That(held[held.Length - 1].Layer.Z, Is.EqualTo(9.6).Within(1e-9));
        Assert.That(held, Has.Length.EqualTo(48), "from the bed on");
        var top = held[held.Length - 1].Support;
        // 9.4 by 20 mm on each side of the post.
        Assert.That(top.Area, Is.EqualTo(2 * 9.4 * 20).Within(3).Percent);
        var lines = Solids.Paths(held[held.Length - 1], Role.SupportInterface).Where(p => !p.IsClosed).Sum(p => p.Length) * Width;
        Assert.That(lines / top.Area, Is.EqualTo(0.7).Within(0.1), "The roof is filled with lines.");
        Assert.That(held.Count(l => Solids.Paths(l, Role.SupportInterface).Length > 0), Is.EqualTo(2));
    }

    [Test]
    public void The_grid_holds_its_share()
    {
        var layers = Solids.Slice(With(SupportKind.Grid) with { SupportDensityPercent = 20, SupportInterfaceLayers = 0 }, Table);
        var lines = Solids.Paths(layers[20], Role.Support).Where(p => !p.IsClosed).Sum(p => p.Length) * Width;
        Assert.That(lines / layers[20].Support.Area, Is.EqualTo(0.2).Within(0.06));
    }

    [Test]
    public void On_the_bed_alone_nothing_stands_on_the_part()
    {
        foreach (var kind in new[] { SupportKind.Grid, SupportKind.Tree })
        {
            // Left of x = −5 there is nothing: the foot covers the whole left side.
            var part = Solids.Slice(With(kind, SupportPlacement.BuildPlate), Footed);
            var foot = part[0].Region;
            foreach (var layer in part.Where(l => l.Layer.Z < 8))
                Assert.That(layer.Support.Intersect(foot).Area, Is.LessThan(kind == SupportKind.Grid ? 1e-6 : 60), $"{kind} at {layer.Layer.Z}");
            // Branches go to the bed anyway where they can.
            if (kind == SupportKind.Grid) Assert.That(part.Sum(l => l.Support.Area), Is.LessThan(Solids.Slice(With(kind), Footed).Sum(l => l.Support.Area)));
        }
    }

    [TestCase(40, true)]
    [TestCase(50, false)]
    public void The_angle_decides_what_is_held(double angle, bool held)
    {
        // A cone that leans out by 45°.
        var layers = Solids.Slice(With(SupportKind.Grid) with { SupportAngle = angle }, Solids.Cone(0, 5, 10, 15));
        Assert.That(layers.Any(l => Solids.Paths(l, Roles).Length > 0), Is.EqualTo(held));
    }

    [TestCase(SupportKind.None, 1)]
    [TestCase(SupportKind.Grid, 0)]
    public void Blockers_and_enforcers_without_supports_are_named(SupportKind kind, int warnings)
    {
        var part = Solids.Block(0, 0, 0, 10, 10, 2);
        var settings = new PrintSettings { Support = kind, MinLayerTime = 0 };
        var result = PlanarSlicer.SliceEach(
            [new SliceModel(new NamedMesh("part", part), settings),
                new SliceModel(new NamedMesh("body", part), settings with { ModelType = ModelType.SupportEnforcer })],
            settings);
        Assert.That(result.Diagnostics.Count(d => d.Code == "slice.no_support" && d.Source!.ToString() == "body"), Is.EqualTo(warnings));
        Assert.That(result.Value!.Layers, Is.Not.Empty);
    }

    [Test]
    public void Blockers_and_enforcers_are_bodies()
    {
        SliceModel Of(string name, PrintSettings settings, params TriMesh[] meshes) => new(new NamedMesh(name, TriMesh.Merge(meshes)), settings);
        double[] Sides(PrintSettings settings, ModelType use)
        {
            var body = Of("body", settings with { ModelType = use }, Solids.Block(-5, -5, 0, 10, 25, 20));
            var layers = PlanarSlicer.SliceEach([Of("part", settings, Table), body], settings).Value!.Layers;
            Assert.That(layers.Select(l => l.Layer.Object).Distinct().ToArray(), Is.EqualTo(new[] { "part" }), "the body is not printed");
            var area = layers[10].Support;
            return [area.Intersect(Region.Rectangle(-10, -10, 15, 30)).Area, area.Intersect(Region.Rectangle(15, -10, 40, 30)).Area];
        }
        var blocked = Sides(With(SupportKind.Grid), ModelType.SupportBlocker);
        Assert.That((blocked[0], blocked[1] > 100), Is.EqualTo((0, true)));
        var enforced = Sides(With(SupportKind.Grid) with { SupportAngle = 90 }, ModelType.SupportEnforcer);
        Assert.That((enforced[0] > 100, enforced[1]), Is.EqualTo((true, 0)));
    }

    [TestCase(SupportKind.Grid)]
    [TestCase(SupportKind.Tree)]
    public void Supports_do_not_depend_on_the_number_of_threads(SupportKind kind)
    {
        var model = new NamedMesh("test", TriMesh.Merge(Footed));
        Vec3[] Of(int threads) => PlanarSlicer.Slice([model], With(kind), new SliceOptions { Threads = threads }).Value!.Layers
            .SelectMany(l => l.Steps).SelectMany(s => s.Path.Points)
            .ToArray();
        Assert.That(Of(4), Is.EqualTo(Of(1)));
    }

    [Test]
    public void Trees_need_less_material_than_a_grid()
    {
        double Volume(SupportKind kind)
            => Solids.Slice(With(kind), Table).SelectMany(l => Solids.Paths(l, Roles)).Sum(p => p.Volume);
        Assert.That(Volume(SupportKind.Tree), Is.LessThan(0.8 * Volume(SupportKind.Grid)));
    }

    [Test]
    public void A_part_that_floats_is_carried()
    {
        var layers = Solids.Slice(With(SupportKind.Grid), Solids.Block(0, 0, 3, 10, 10, 5));
        Assert.That(layers[0].Layer.Z, Is.EqualTo(0.2).Within(1e-9));
        Assert.That(Solids.Paths(layers[0], Role.Support), Is.Not.Empty);
        Assert.That(layers[0].Region.IsEmpty);
    }

    [Test]
    public void Skirts_go_around_supports()
    {
        var first = Solids.Slice(With(SupportKind.Grid) with { SkirtLoops = 1, SkirtDistance = 3 }, Table)[0];
        var skirt = Solids.Paths(first, Role.Skirt).Single();
        Assert.That(skirt.Bounds.Min.X, Is.LessThan(-2.5));
    }

    [TestCase("support=pillars", "support")]
    [TestCase("support_angle_deg=91", "support_angle_deg")]
    [TestCase("support_xy_gap_mm=0", "support_xy_gap_mm")]
    [TestCase("support_density_percent=0", "support_density_percent")]
    [TestCase("tree_tip_distance_mm=0", "tree_tip_distance_mm")]
    [TestCase("support_placement=table", "support_placement")]
    [TestCase("model_type=toy", "model_type")]
    public void Bad_values_name_their_key(string set, string key)
        => Assert.That(new PrintSetup().With(set).Diagnostics.Single().ToString(), Does.Contain(key));
}
