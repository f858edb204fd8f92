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

public class SeamTests
{
    private static readonly PrintSettings Bare = new()
    {
        LineWidth = 0.4, BeadShape = BeadShape.Rectangle, Resolution = 0, TopLayers = 0, BottomLayers = 0, InfillDensityPercent = 0,
        WallCount = 2, MinLayerTime = 0,
    };

    private static readonly Vec3[] Ell = [new(0, 0), new(20, 0), new(20, 8), new(8, 8), new(8, 20), new(0, 20)];

    private static TriMesh EllSolid => TriMesh.Merge([Solids.Block(0, 0, 0, 20, 8, 4), Solids.Block(0, 0, 0, 8, 20, 4)]);

    private static Vec3[] Seams(IEnumerable<SlicedLayer> layers)
        => layers.SelectMany(l => l.Steps).Where(s => s.Path.Role is Role.OuterWall or Role.OverhangWall).Select(s => s.Path.Start.WithZ(0)).ToArray();

    private static PrintSettings At(SeamPosition position) => Bare with { SeamPosition = position };

    [Test]
    public void Aligned_seams_lie_in_the_same_corner_of_all_layers()
    {
        var seams = Seams(Solids.Slice(At(SeamPosition.Aligned), Solids.Block(0, 0, 0, 20, 20, 4)));
        Assert.That(seams, Has.Length.EqualTo(20));
        Assert.That(seams.Distinct().ToArray(), Has.Length.EqualTo(1));
        Assert.That(new[] { new Vec3(0.2, 19.8), new Vec3(19.8, 19.8) }.Min(c => c.DistanceTo(seams[0])), Is.LessThan(1e-3), "a corner at the back");
    }

    [TestCase(SeamPosition.Aligned)]
    [TestCase(SeamPosition.Corner)]
    public void A_concave_corner_hides_the_seam(SeamPosition position)
        => Assert.That(Seams(Solids.Slice(At(position), EllSolid)).Select(s => s.DistanceTo(new Vec3(7.8, 7.8))), Is.All.LessThan(1e-3));

    [Test]
    public void Seams_at_the_back_lie_in_the_middle_of_a_straight_back()
        => Assert.That(Seams(Solids.Slice(At(SeamPosition.Rear), Solids.Block(0, 0, 0, 20, 20, 4))).Select(s => s.DistanceTo(new Vec3(10, 19.8))),
            Is.All.LessThan(1e-2));

    [Test]
    public void Seams_lie_on_the_side_of_a_point()
        => Assert.That(
            Seams(Solids.Slice(At(SeamPosition.Point) with { SeamPoint = new Vec3(-50, 5) }, Solids.Block(0, 0, 0, 20, 20, 4)))
                .Select(s => s.DistanceTo(new Vec3(0.2, 5))),
            Is.All.LessThan(1e-2));

    [Test]
    public void Random_seams_depend_on_the_seed_alone()
    {
        Vec3[] Of(int seed) => Seams(Solids.Slice(At(SeamPosition.Random) with { SeamSeed = seed }, Solids.Block(0, 0, 0, 20, 20, 4)));
        var seams = Of(1);
        Assert.That(seams, Is.EqualTo(Of(1)));
        Assert.That(seams, Is.Not.EqualTo(Of(2)));
        Assert.That(seams.Distinct().Count(), Is.GreaterThan(15));
        foreach (var side in new[] { seams.Count(s => s.X < 1), seams.Count(s => s.X > 19), seams.Count(s => s.Y < 1), seams.Count(s => s.Y > 19) })
            Assert.That(side, Is.GreaterThan(0), "every side has some");
    }

    [Test]
    public void No_seam_lies_over_air([Values(SeamPosition.Aligned, SeamPosition.Corner, SeamPosition.Rear, SeamPosition.Point, SeamPosition.Random,
        SeamPosition.Nearest)] SeamPosition position)
    {
        // The slab reaches 10 mm over the block on two sides; three of its corners are in the air. An extrusion touches the block up to 20.2 mm.
        var settings = At(position) with { SeamPoint = new Vec3(50, 50) };
        var layers = Solids.Slice(settings, Solids.Block(0, 0, 0, 20, 20, 2), Solids.Block(0, 0, 2, 30, 30, 4));
        var first = layers[10].Steps.Select(s => s.Path).Where(p => p.IsClosed).ToArray();
        Assert.That(first, Has.Length.EqualTo(2), "two walls");
        foreach (var wall in first)
            Assert.That(Math.Max(wall.Start.X, wall.Start.Y), Is.LessThanOrEqualTo(19.2 + 1e-6), $"{wall.Role} begins at {wall.Start}");
    }

    [Test]
    public void A_loop_all_in_the_air_and_a_painted_one_begin_as_usual()
    {
        var ring = Solids.Slice(At(SeamPosition.Rear), Solids.Block(5, 5, 0, 15, 15, 2), Solids.Block(0, 0, 2, 20, 20, 4));
        Assert.That(Seams([ring[10]]).Min(s => s.DistanceTo(new Vec3(10, 19.8))), Is.LessThan(1e-2));
        var marks = new ValueList<SeamMark>(new SeamMark(new Vec3(30, 12, 2.1), 1));
        var painted = Solids.Slice(At(SeamPosition.Rear) with { SeamEnforcers = marks }, Solids.Block(0, 0, 0, 20, 20, 2), Solids.Block(0, 0, 2, 30, 30, 4));
        Assert.That(Seams([painted[10]]).Min(s => s.DistanceTo(new Vec3(29.8, 12))), Is.LessThan(1e-2));
    }

    [Test]
    public void Loops_begin_at_painted_places_and_elsewhere_as_usual()
    {
        var marks = new ValueList<SeamMark>(new SeamMark(new Vec3(20, 12, 2), 1));
        var layers = Solids.Slice(At(SeamPosition.Rear) with { SeamEnforcers = marks }, Solids.Block(0, 0, 0, 20, 20, 4));
        foreach (var layer in layers)
        {
            var middle = layer.Layer.Z - 0.1;
            // The wall passes the center of the ball at 0.2 mm.
            var painted = 0.2 * 0.2 + (middle - 2) * (middle - 2) < 1;
            Assert.That(Seams([layer])[0].DistanceTo(painted ? new Vec3(19.8, 12) : new Vec3(10, 19.8)), Is.LessThan(1e-2), $"{layer.Layer.Z}");
        }
    }

    [Test]
    public void Seams_that_may_lie_anywhere_are_left_to_planning()
    {
        Assert.That(Solids.Slice(At(SeamPosition.Nearest), EllSolid).SelectMany(l => l.Steps).Select(s => s.KeepStart), Is.All.False);
        Assert.That(Solids.Slice(At(SeamPosition.Aligned), EllSolid).SelectMany(l => l.Steps).Select(s => s.KeepStart), Is.All.True);
    }

    [Test]
    public void Inner_walls_begin_beside_the_seam()
    {
        foreach (var layer in Solids.Slice(At(SeamPosition.Aligned), EllSolid))
        {
            var paths = Solids.Paths(layer);
            Assert.That(paths.Select(p => p.Role), Is.EqualTo(new[] { Role.InnerWall, Role.OuterWall }));
            Assert.That(paths[0].Start.DistanceTo(paths[1].Start), Is.LessThan(0.6));
        }
    }

    [Test]
    public void Seams_do_not_depend_on_the_number_of_threads()
    {
        var model = new NamedMesh("test", TriMesh.Merge([EllSolid, Solids.Cone(0, 8, 9, 2)]));
        Vec3[] Of(int threads) => Seams(PlanarSlicer.Slice([model], At(SeamPosition.Aligned), new SliceOptions { Threads = threads }).Value!.Layers);
        Assert.That(Of(4), Is.EqualTo(Of(1)));
    }

    [Test]
    public void Two_objects_keep_their_own_seams()
    {
        NamedMesh[] models = [new("a", Solids.Block(0, 0, 0, 10, 10, 2)), new("b", Solids.Block(20, 0, 0, 30, 10, 2))];
        var layers = PlanarSlicer.Slice(models, At(SeamPosition.Aligned)).Value!.Layers;
        foreach (var name in new[] { "a", "b" })
            Assert.That(Seams(layers.Where(l => l.Layer.Object == name)).Distinct().ToArray(), Has.Length.EqualTo(1), name);
    }

    [Test]
    public void A_scarf_begins_in_the_second_layer()
    {
        var layers = Solids.Slice(At(SeamPosition.Aligned) with { ScarfSeamLength = 10 }, EllSolid);
        Assert.That(Solids.Paths(layers[0], Role.OuterWall).Single().IsClosed);
        foreach (var layer in layers.Skip(1))
        {
            var wall = Solids.Paths(layer, Role.OuterWall).Single();
            Assert.That(wall.IsClosed, Is.False);
            Assert.That(wall.Start.Z, Is.EqualTo(layer.Layer.Z - 0.18).Within(1e-9));
            Assert.That(wall.Start.WithZ(0).DistanceTo(new Vec3(7.8, 7.8)), Is.LessThan(1e-3));
        }
        Assert.That(Solids.Volume(layers), Is.EqualTo(Solids.Volume(Solids.Slice(Bare, EllSolid))).Within(0.01).Percent);
    }

    [Test]
    public void The_seam_of_a_ball_hops_only_where_its_wall_leaves_the_air()
    {
        // Circles around Z, joined by quads; the poles are the first and the last vertex.
        const int Around = 96, Up = 48;
        var points = new List<Vec3> { new(0, 0, 0) };
        var corners = new List<int>();
        for (var t = 1; t < Up; t++)
        {
            var (ring, height) = Angle.SinCos(180.0 * t / Up);
            for (var i = 0; i < Around; i++)
            {
                var (y, x) = Angle.SinCos(360.0 * i / Around);
                points.Add(new Vec3(20 * ring * x, 20 * ring * y, 20 - 20 * height));
            }
        }
        points.Add(new Vec3(0, 0, 40));
        for (var i = 0; i < Around; i++)
        {
            var j = (i + 1) % Around;
            corners.AddRange([0, 1 + j, 1 + i]);
            for (var t = 0; t + 2 < Up; t++)
            {
                var (a, b) = (1 + t * Around + i, 1 + t * Around + j);
                corners.AddRange([a, b, b + Around, a, b + Around, a + Around]);
            }
            corners.AddRange([1 + (Up - 2) * Around + i, 1 + (Up - 2) * Around + j, points.Count - 1]);
        }
        var ball = TriMesh.Create([.. points], [.. corners]);
        Assert.That(ball.IsWatertight && ball.Volume > 33000);
        var result = PlanarSlicer.Slice([new NamedMesh("ball", ball)], new PrintSettings { InfillDensityPercent = 0, MinLayerTime = 0 });
        var seams = result.Value!.Layers.Select(l => Seams([l])).Where(s => s.Length > 0).ToArray();
        for (var i = 1; i < seams.Length; i++)
        {
            if (seams[i][0].Z < 2.5) continue;
            foreach (var seam in seams[i])
                Assert.That(seams[i - 1].Min(b => b.WithZ(0).DistanceTo(seam.WithZ(0))), Is.LessThan(2), $"at z {seam.Z}");
        }
    }

    [TestCase("meshes/torus.obj")]
    [TestCase("meshes/spot.obj")]
    [TestCase("meshes/homer.stl")]
    [TestCase("meshes/fandisk.stl")]
    public void Aligned_seams_of_real_parts_hardly_jump(string file)
    {
        var mesh = MeshReader.Read(TestData.Shared(file)).Value!;
        var result = PlanarSlicer.Slice(mesh, new PrintSettings { InfillDensityPercent = 0, TopLayers = 0, BottomLayers = 0, LayerHeight = 0.3,
            MinLayerTime = 0 });
        var jumps = new List<double>();
        Vec3[]? below = null;
        foreach (var layer in result.Value!.Layers)
        {
            var seams = Seams([layer]);
            if (below is { Length: > 0 }) jumps.AddRange(seams.Select(s => below.Min(b => b.DistanceTo(s))));
            below = seams;
        }
        jumps.Sort();
        Assert.That(jumps[jumps.Count / 2], Is.LessThan(0.2));
    }

    [TestCase("0,20,5,3; 1,2,3,4")]
    [TestCase("[0, 20, 5, 3]; [1, 2, 3, 4]")]
    [TestCase("[[0,20,5,3],[1,2,3,4]]")]
    [TestCase(" [ [0, 20, 5, 3] , [1, 2, 3, 4] ] ")]
    public void Marks_are_rows_with_or_without_brackets(string text)
    {
        var setup = new PrintSetup().With("seam_enforcers_mm=" + text);
        Assert.That(setup.Diagnostics, Is.Empty);
        Assert.That(setup.Value!.Settings.SeamEnforcers.Select(m => (m.Place, m.Radius)),
            Is.EqualTo(new[] { (new Vec3(0, 20, 5), 3.0), (new Vec3(1, 2, 3), 4.0) }));
        Assert.That(new PrintSetup().With("seam_enforcers_mm=[]").Value!.Settings.SeamEnforcers, Is.Empty);
    }

    [TestCase("seam_enforcers_mm=[[1,2,3,4]", "seam_enforcers_mm")]
    [TestCase("seam_enforcers_mm=[1,2],[3,4]", "seam_enforcers_mm")]
    [TestCase("seam_position=somewhere", "seam_position")]
    [TestCase("seam_enforcers_mm=1,2,3,0", "seam_enforcers_mm")]
    [TestCase("seam_enforcers_mm=1,2,3", "seam_enforcers_mm")]
    [TestCase("seam_point_mm=1", "seam_point_mm")]
    [TestCase("scarf_seam_length_mm=0.05", "scarf_seam_length_mm")]
    [TestCase("scarf_seam_steps=1", "scarf_seam_steps")]
    [TestCase("wall_order=sideways", "wall_order")]
    public void Bad_values_name_their_key(string set, string key)
        => Assert.That(new PrintSetup().With(set).Diagnostics.Single().ToString(), Does.Contain(key));
}
