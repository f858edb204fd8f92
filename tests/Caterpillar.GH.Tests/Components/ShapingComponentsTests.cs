using System;
using System.IO;
using System.Linq;
using Caterpillar.Files;
using Caterpillar.GH.Components.Path;
using Caterpillar.GH.Goos;
using Caterpillar.GH.Tests.Host;
using Caterpillar.Machines;
using Caterpillar.Geometry;
using Caterpillar.Toolpaths;
using Caterpillar.Traces;
using NUnit.Framework;
using Rhino;

namespace Caterpillar.GH.Tests.Components;

[Category("Host")]
public sealed class ShapingComponentsTests
{
    private static readonly PrintPath Line = new([new Vec3(0, 0, 1), new Vec3(10, 0, 1), new Vec3(10, 10, 3)], new Bead(0.2, 0, 30));

    private static readonly PrintPath Helix = new Trace(0.196).SetSpeed(30).Helix(Vec3.Zero, 10, 4, 0.4, 36).ToPaths().Single();

    [Test]
    public void Formulas_deform_paths()
    {
        var canvas = new Canvas<DeformComponent>().Feed("Print Paths", Line).Feed("Changes", "Position", "Area", "Speed").Feed("X", "x + z")
            .Feed("Area", "2 * c").Feed("Speed", "v / 3")
            .Feed("Tolerance", 0.0).Solve();
        Assert.That(canvas.Errors, Is.Empty);
        var path = canvas.One<PrintPath>("Print Paths");
        Assert.That(path.Points, Is.EqualTo(new[] { new Vec3(1, 0, 1), new Vec3(11, 0, 1), new Vec3(13, 10, 3) }));
        Assert.That((path.BeadOf(0).Area, path.BeadOf(0).Speed), Is.EqualTo((0.4, 10.0)));
    }

    [Test]
    public void Cylindrical_formulas_see_the_frame_in_document_units()
    {
        using var _ = new InDocument(UnitSystem.Centimeters);
        var path = Helix.Transformed(Affine.Move(new Vec3(50, 20, 5)));
        var canvas = new Canvas<DeformComponent>().Feed("Print Paths", path).Feed("System", "Cylindrical").Feed("R", "r + z").Feed("Theta", "theta")
            .Feed("Tolerance", 0.01)
            .Feed("Plane", new Rg.Plane(new Rg.Point3d(5, 2, 0.5), Rg.Vector3d.XAxis, Rg.Vector3d.YAxis)).Solve();
        Assert.That(canvas.Errors, Is.Empty);
        var cone = canvas.One<PrintPath>("Print Paths");
        Assert.That(cone.End.DistanceTo(new Vec3(64, 20, 9)), Is.LessThan(1e-9));
        Assert.That(cone.SegmentCount, Is.GreaterThanOrEqualTo(360));
        Assert.That(canvas.Notes.Single(), Does.Contain("centimeters"));
    }

    [Test]
    public void Groups_of_slicers_stay_with_their_paths()
    {
        var group = new StepGroup(1, 2);
        var canvas = new Canvas<DeformComponent>().Feed("Print Paths", new PrintPathGoo(new PathStep(Line, group))).Feed("Z", "z + 1").Solve();
        Assert.That(((PrintPathGoo)canvas.Output("Print Paths").VolatileData.get_Branch(0)[0]!).ToStep().Group, Is.EqualTo(group));
    }

    [Test]
    public void A_path_that_cannot_be_deformed_does_not_stop_the_others()
    {
        var canvas = new Canvas<DeformComponent>().Feed("Print Paths", Line, null, Helix).Feed("X", "x / (y - 0)").Feed("Tolerance", 0.0).Solve();
        Assert.That(canvas.All("Print Paths").Select(p => p is null), Is.EqualTo(new[] { true, true }));
        Assert.That(canvas.Errors.Single(), Does.Contain("shape.position").And.Contain("2 times"));
        Assert.That(canvas.Warnings.Single(), Does.Contain("1 null item"));
        var one = new Canvas<DeformComponent>().Feed("Print Paths", Line, new PrintPath([new Vec3(0, 0, 5), new Vec3(1, 1, 5)], new Bead(0.2)))
            .Feed("X", "x / (z - 1)").Feed("Tolerance", 0.0).Solve();
        Assert.That(one.All("Print Paths").Select(p => p is null), Is.EqualTo(new[] { true, false }));
        Assert.That(one.All("Diagnostics").Single(), Does.StartWith("step 0: error shape.position"));
    }

    [Test]
    public void Errors_in_formulas_have_their_column()
    {
        var canvas = new Canvas<DeformComponent>().Feed("Print Paths", Line).Feed("Changes", "Position", "Area").Feed("X", "x + w").Feed("Area", "2 *").Solve();
        Assert.That(canvas.All("Print Paths"), Is.Empty);
        Assert.That(canvas.Errors, Has.Count.EqualTo(2));
        Assert.That(canvas.Errors[0], Does.Contain("line 1:5: position.x").And.Contain("x + w"));
        Assert.That(new Canvas<DeformComponent>().Feed("X", "x").Solve().Warnings.Single(), Does.Contain("failed to collect data"));
        Assert.That(new Canvas<DeformComponent>().Feed("Print Paths", Line).Feed("Tolerance", -1.0).Solve().Errors.Single(),
            Does.Contain("Tolerance must be 0 or more"));
        var slow = new Canvas<DeformComponent>().Feed("Print Paths", new PrintPath([Vec3.Zero, Vec3.UnitX], new Bead(0.2))).Feed("Changes", "Speed")
            .Feed("Speed", "v / 2").Solve();
        Assert.That(slow.Warnings.Single(), Does.Contain("v is 0"));
        Assert.That(new Canvas<DeformComponent>().FeedTree("Print Paths", [Line], [Line, Helix]).Solve().Paths("Print Paths"),
            Is.EqualTo(new[] { "{0;0}", "{1;0}" }));
    }

    [Test]
    public void Expressions_modulate_speed_flow_and_place()
    {
        var speed = Modulate("Speed", "x > 9 ? 1 : 0");
        Assert.That((speed.BeadOf(0).Speed, speed.BeadOf(1).Speed), Is.EqualTo((30.0, 30 * 0.65)));
        Assert.That(speed.BeadOf(1).Area, Is.EqualTo(0.2 / 0.65).Within(1e-12));
        var flow = Modulate("Flow", "u");
        Assert.That(flow.BeadOf(0).Area, Is.EqualTo(0.2 * (1 - 0.35 * 5 / Line.Length)).Within(1e-12));
        var place = Modulate("Displace Up", "1");
        Assert.That(place.Start.Z, Is.EqualTo(1.65));
    }

    [Test]
    public void Images_are_mapped_around_the_paths()
    {
        var file = System.IO.Path.Combine(System.IO.Path.GetTempPath(), "caterpillar-modulate-" + Guid.NewGuid().ToString("N") + ".png");
        var halves = new RasterImage(2, 1, new Rgb(0, 0, 0)) { [1, 0] = new Rgb(255, 255, 255) };
        File.WriteAllBytes(file, PngWriter.ToBytes(halves));
        try
        {
            var canvas = new Canvas<ModulateComponent>().Feed("Print Paths", Helix).Feed("Source", "Image").Feed("Image", file).Feed("High", 0.7).Solve();
            Assert.That(canvas.Errors, Is.Empty);
            var path = canvas.One<PrintPath>("Print Paths");
            // The first half of each turn is black, the other white.
            Assert.That(Enumerable.Range(0, 360).Select(i => path.BeadOf(i).Speed),
                Is.EqualTo(Enumerable.Range(0, 360).Select(i => i % 36 < 18 ? 30.0 : 30 * 0.7)).Within(1e-12));
            var twice = new Canvas<ModulateComponent>().Feed("Print Paths", Helix).Feed("Source", "Image").Feed("Image", file).Feed("High", 0.7)
                .Feed("Repeat", 2).Solve().One<PrintPath>("Print Paths");
            Assert.That(twice.BeadOf(10).Speed, Is.EqualTo(21).Within(1e-12));
            foreach (var mapping in new[] { "Globe", "Plan", "Along" })
            {
                var other = new Canvas<ModulateComponent>().Feed("Print Paths", Helix).Feed("Source", "Image").Feed("Image", file).Feed("High", 0.7)
                    .Feed("Mapping", mapping).Feed("Smooth", true).Solve();
                Assert.That(other.Errors, Is.Empty, mapping);
                Assert.That(other.One<PrintPath>("Print Paths").IsUniform, Is.False, mapping);
            }
            var flat = new PrintPath([Vec3.Zero, Vec3.UnitX], new Bead(0.2, 0, 30));
            foreach (var mapping in new[] { "Cylinder", "Plan" })
            {
                var refused = new Canvas<ModulateComponent>().Feed("Print Paths", flat).Feed("Source", "Image").Feed("Image", file).Feed("Mapping", mapping);
                Assert.That(refused.Solve().Errors.Single(), Does.Contain("too flat for the mapping " + mapping));
            }
            File.WriteAllText(file, "no image");
            Assert.That(new Canvas<ModulateComponent>().Feed("Print Paths", Helix).Feed("Source", "Image").Feed("Image", file).Solve().Errors.Single(),
                Does.Contain("image.unreadable"));
        }
        finally
        {
            File.Delete(file);
        }
        Assert.That(new Canvas<ModulateComponent>().Feed("Print Paths", Helix).Feed("Source", "Image").Feed("Image", file).Solve().Errors,
            Has.Count.EqualTo(1));
    }

    [Test]
    public void Masks_resolution_and_the_speed_of_the_setup_take_effect()
    {
        var path = new PrintPath([Vec3.Zero, new Vec3(10, 0, 0)], new Bead(0.2));
        var canvas = new Canvas<ModulateComponent>().Feed("Print Paths", path).Feed("Expression", "1").Feed("Mask", "step(5, x)").Feed("Resolution", 2.5)
            .Solve();
        Assert.That(canvas.Errors, Is.Empty);
        var parts = canvas.One<PrintPath>("Print Paths");
        Assert.That(Enumerable.Range(0, parts.SegmentCount).Select(i => parts.BeadOf(i).Speed), Is.EqualTo(new[] { 60.0, 60, 39, 39 }).Within(1e-12),
            "The speed of standard settings.");
        var slow = new PrintPathGoo(path, new PrintSetup { Settings = new PrintSettings { PrintSpeed = 40 } });
        canvas.Feed("Print Paths", slow).Solve();
        Assert.That(canvas.One<PrintPath>("Print Paths").BeadOf(0).Speed, Is.EqualTo(40).Within(1e-12), "The speed of the setup of the paths.");
    }

    [Test]
    public void Bad_modulations_are_named()
    {
        Canvas<ModulateComponent> With(string input, object? value)
            => new Canvas<ModulateComponent>().Feed("Print Paths", Line).Feed("Expression", "u").Feed(input, value).Solve();
        Assert.That(new Canvas<ModulateComponent>().Feed("Print Paths", Line).Solve().Warnings.Single(), Does.Contain("E failed to collect data"));
        Assert.That(With("Expression", "q").Errors.Single(), Does.Contain("line 1:1: expression.field"));
        Assert.That(With("Mask", "1 +").Errors.Single(), Does.Contain("mask.field"));
        Assert.That(With("High", 0.0).Errors, Is.Empty);
        Assert.That(With("High", -1.0).Errors.Single(), Does.Contain("stay positive"));
        Assert.That(With("High", 0.3).Warnings.Single(), Does.Contain("shape.modulation_ratio"));
        Assert.That(With("Resolution", -1.0).Errors.Single(), Does.Contain("Resolution must be 0 or more"));
        Assert.That(new Canvas<ModulateComponent>().Feed("Print Paths", Line).Feed("Source", "Image").Feed("Image", "none.png").Feed("Repeat", 0).Solve()
            .Errors.Single(), Does.Contain("Repeat must be 1 or more"));
        Assert.That(With("Print Paths", null).Errors, Has.Some.Contain("Print Paths: the connected source gives no valid data"));
        var tree = new Canvas<ModulateComponent>().FeedTree("Print Paths", [Line], [Line, Helix]).Feed("Expression", "u").Solve();
        Assert.That(tree.Paths("Print Paths"), Is.EqualTo(new[] { "{0;0}", "{1;0}" }));
    }

    [Test]
    public void Small_layers_slow_down()
    {
        PrintPath Ring(double radius, double z) => new Trace(0.196, new Vec3(0, 0, z)).SetSpeed(50).Circle(new Vec3(0, 0, z), radius, 36).ToPaths().Single();
        var canvas = new Canvas<CoolLayersComponent>().Feed("Print Paths", Ring(5, 0.2), Ring(100, 0.4)).Feed("Minimum Layer Time", 4.0).Solve();
        Assert.That(canvas.Errors, Is.Empty);
        var paths = canvas.All("Print Paths").Cast<PrintPath>().ToArray();
        Assert.That(paths[0].Length / paths[0].BeadOf(0).Speed, Is.EqualTo(4).Within(1e-9));
        Assert.That(paths[1].BeadOf(0).Speed, Is.EqualTo(50));
        var kanada = new Canvas<CoolLayersComponent>().Feed("Print Paths", Line).Feed("Minimum Layer Time", 0.0).Feed("Speed By Length", true).Solve()
            .One<PrintPath>("Print Paths");
        Assert.That(kanada.BeadOf(0).Speed, Is.EqualTo(11));
        Assert.That(new Canvas<CoolLayersComponent>().Feed("Print Paths", Ring(1, 0.2)).Feed("Maximum Segment Rate", 50.0).Feed("Minimum Layer Time", 0.0)
            .Solve().Warnings.Single(), Does.Contain("shape.short_segments"));
    }

    [Test]
    public void Bad_cooling_is_named()
    {
        Assert.That(new Canvas<CoolLayersComponent>().Solve().Warnings.Single(), Does.Contain("failed to collect data"));
        Assert.That(new Canvas<CoolLayersComponent>().Feed("Print Paths", Line).Feed("Minimum Layer Time", -1.0).Solve().Errors.Single(),
            Does.Contain("0 or more"));
        Assert.That(new Canvas<CoolLayersComponent>().Feed("Print Paths", Line).Feed("Minimum Speed", 0.0).Solve().Errors.Single(),
            Does.Contain("Minimum Speed must be greater than zero"));
        var canvas = new Canvas<CoolLayersComponent>().FeedTree("Print Paths", [Line, null], [Helix]).Solve();
        Assert.That(canvas.Paths("Print Paths"), Is.EqualTo(new[] { "{0;0}", "{1;0}" }));
        Assert.That(canvas.Warnings, Has.Some.Contain("1 null item"));
    }

    private static PrintPath Modulate(string mode, string expression)
    {
        var canvas = new Canvas<ModulateComponent>().Feed("Print Paths", Line).Feed("Expression", expression).Feed("Mode", mode).Solve();
        Assert.That(canvas.Errors, Is.Empty);
        return canvas.One<PrintPath>("Print Paths");
    }
}
