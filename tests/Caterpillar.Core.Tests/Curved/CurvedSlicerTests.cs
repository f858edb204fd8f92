using System;
using System.Linq;
using Caterpillar.Basics;
using Caterpillar.Checks;
using Caterpillar.Curved;
using Caterpillar.GCode;
using Caterpillar.Geometry;
using Caterpillar.Machines;
using Caterpillar.Planning;
using Caterpillar.Slicing;
using Caterpillar.Tests.Slicing;
using Caterpillar.Toolpaths;
using NUnit.Framework;

namespace Caterpillar.Tests.Curved;

public class CurvedSlicerTests
{
    private static double Tilted(double x, double y) => 0.2 * x + 0.1 * y;

    private static double Wave(double x, double y) => 1.5 * Angle.Sin(12 * x);

    private static double Bowl(double x, double y) => (x * x + y * y) / 60;

    // The part lies between two copies of the plan, so that every layer is whole: 12 layers of 0.5 mm.
    [TestCase("tilted")]
    [TestCase("wave")]
    [TestCase("bowl")]
    public void Layers_parallel_to_a_plan_have_its_height_and_the_volume_of_the_part(string plan)
    {
        Func<double, double, double> surface = plan switch { "tilted" => Tilted, "wave" => Wave, _ => Bowl };
        var box = CurvedSolids.Plan(-15, -10, 15, 10);
        var part = CurvedSolids.Between(box, 120, (x, y) => surface(x, y) + 5, (x, y) => surface(x, y) + 11);
        var field = LayerField.Vertical(PlanSurface.Of(surface, plan == "tilted" ? double.PositiveInfinity : 2));
        var layers = CurvedSolids.Slice(field, CurvedSolids.Massive, part);
        Assert.That(layers, Has.Count.EqualTo(12));
        for (var i = 0; i < layers.Count; i++)
        {
            foreach (var p in CurvedSolids.Points(layers[i])) Assert.That(p.Z, Is.EqualTo(surface(p.X, p.Y) + 5 + 0.5 * (i + 1)).Within(1e-6));
            Assert.That(CurvedSolids.Volume(layers[i]), Is.EqualTo(30 * 20 * 0.5).Within(1).Percent, $"layer {i}");
        }
    }

    [TestCase("level")]
    [TestCase("function")]
    public void The_field_z_gives_the_print_of_the_planar_slicer(string kind)
    {
        var setup = new PrintSetup().With("layer_height_mm=0.3", "infill_density_percent=15").OrThrow();
        var models = ModelPlacement.OnBed(
        [
            new("cone", Solids.Cone(0, 12, 9, 5)), new("block", Solids.Block(20, -5, 0, 30, 5, 4)),
                new("roof", Solids.Cone(5, 3, 8, 10).Moved(new Vec3(50, 0, -5))),
        ], new Vec3(110, 110));
        var field = kind == "level" ? LayerField.Vertical(PlanSurface.Level(0)) : LayerField.Of(p => p.Z, double.PositiveInfinity);
        if (kind == "function") setup = setup with { Settings = setup.Settings with { SkirtLoops = 0, CurvedMaxSlope = 5 } };
        var curved = Decoded(CurvedSlicer.Slice(models, field, setup).OrThrow(), setup);
        var planar = Decoded(PlanarSlicer.Slice(models, setup.Settings).OrThrow(), setup);
        Assert.That(curved.Count, Is.EqualTo(planar.Count));
        for (var i = 0; i < planar.Count; i++)
        {
            Assert.That(curved[i].End.DistanceTo(planar[i].End), Is.LessThan(1e-3), $"move {i}");
            Assert.That(curved[i].E, Is.EqualTo(planar[i].E).Within(Math.Max(1e-5, 1e-4 * Math.Abs(planar[i].E))), $"move {i}");
            Assert.That(curved[i].Kind, Is.EqualTo(planar[i].Kind), $"move {i}");
        }
    }

    [Test]
    public void Layers_at_equal_distances_from_a_tube_have_its_axis_and_the_volume_between_their_cylinders()
    {
        var tube = CurvedSolids.Arch(20, 23, 60, 120, 6, 160);
        var field = LayerField.Offset(CurvedSolids.Sheet(20, 50, 130, 8, 250));
        var layers = CurvedSolids.Slice(field, CurvedSolids.Massive, tube);
        Assert.That(layers, Has.Count.EqualTo(6));
        for (var i = 0; i < layers.Count; i++)
        {
            var radius = 20.5 + 0.5 * i;
            foreach (var p in CurvedSolids.Points(layers[i])) Assert.That(Math.Sqrt(p.X * p.X + p.Z * p.Z), Is.EqualTo(radius).Within(1e-3));
            var volume = Angle.ToRadians(60) * (radius * radius - (radius - 0.5) * (radius - 0.5)) / 2 * 6;
            Assert.That(CurvedSolids.Volume(layers[i]), Is.EqualTo(volume).Within(2).Percent, $"layer {i}");
        }
    }

    [Test]
    public void Layers_of_a_cone_between_two_planes_divide_its_height_evenly()
    {
        // The highest place over the part, 10.4 mm, decides: 0.5 + 20 · 0.5 mm.
        static double Roof(double x, double y) => 8 + 0.2 * x;
        var high = Solids.Circle(8, 96).Select(p => p.WithZ(Roof(p.X, p.Y))).ToArray();
        var part = CurvedSolids.Loft(Solids.Circle(12, 96), high);
        var field = LayerField.Between(PlanSurface.Level(0), PlanSurface.Of(Roof));
        var layers = CurvedSolids.Slice(field, CurvedSolids.Massive, part);
        Assert.That(layers, Has.Count.EqualTo(21));
        for (var i = 0; i < 21; i++)
        {
            foreach (var p in CurvedSolids.Points(layers[i])) Assert.That(p.Z, Is.EqualTo(Roof(p.X, p.Y) * (i + 1) / 21).Within(1e-6));
            Assert.That(CurvedSolids.Volume(layers[i]), Is.EqualTo(VolumeOfLayer(i)).Within(2).Percent, $"layer {i}");
        }
        Assert.That(layers.Sum(CurvedSolids.Volume), Is.EqualTo(part.Volume).Within(2).Percent);

        // Over each place, what lies between two layers and below the side, which rises from the rim at 12 mm to the one at 8 mm.
        static double VolumeOfLayer(int layer)
        {
            const double Step = 0.05;
            var sum = 0.0;
            for (var x = -12 + Step / 2; x < 12; x += Step)
            {
                for (var y = -12 + Step / 2; y < 12; y += Step)
                {
                    var radius = Math.Sqrt(x * x + y * y);
                    var side = radius < 8 ? Roof(x, y) : Math.Max(0, (12 - radius) / 4 * Roof(8 * x / radius, 8 * y / radius));
                    sum += Math.Max(0, Math.Min(side, Roof(x, y) * (layer + 1) / 21) - Roof(x, y) * layer / 21);
                }
            }
            return sum * Step * Step;
        }
    }

    // Each with gaps of about 1 : 4.
    [TestCase("between")]
    [TestCase("blend")]
    [TestCase("formula")]
    public void The_extrusions_of_a_layer_have_the_volume_of_the_gap_below_it(string kind)
    {
        static double Roof(double x, double y) => 5 + 0.2 * x;
        var box = CurvedSolids.Plan(-15, -8, 15, 8);
        var part = CurvedSolids.Between(box, 60, (_, _) => 0, Roof);
        var field = kind switch
        {
            "between" => LayerField.Between(PlanSurface.Level(0), PlanSurface.Of(Roof)),
            "blend" => LayerField.Vertical(PlanSurface.Of(Roof), new LayerBlend(0, 8)),
            _ => LayerField.Formula("z * 8 / (5 + 0.2 * x)").OrThrow(),
        };
        var fitted = field.FitTo(PartColumns.Of([part]), CurvedSolids.Massive, new DiagnosticList());
        var layers = CurvedSolids.Slice(field, CurvedSolids.Massive, part);
        Assert.That(layers, Has.Count.EqualTo(16));
        var all = 0.0;
        for (var i = 0; i < layers.Count; i++)
        {
            var expected = CurvedSolids.VolumeBetween(fitted, box, layers[i].Layer.Z - 0.5, layers[i].Layer.Z, (_, _) => 0, Roof);
            all += expected;
            Assert.That(CurvedSolids.Volume(layers[i]), Is.EqualTo(expected).Within(2).Percent, $"layer {i}");
        }
        Assert.That(all, Is.EqualTo(part.Volume).Within(0.1).Percent);
        var heights = layers.SelectMany(l => l.Steps).SelectMany(s => Enumerable.Range(0, s.Path.SegmentCount).Select(k => s.Path.BeadOf(k).Height)).ToArray();
        Assert.That(heights.Max() / heights.Min(), Is.InRange(2.9, 5.1));
    }

    [Test]
    public void What_is_written_is_read_back_with_X_Y_and_Z_in_every_printing_move()
    {
        var setup = new PrintSetup { Settings = CurvedSolids.Massive with { LayerHeight = 0.3, FirstLayerHeight = 0.3, InfillDensityPercent = 20,
            LineWidth = 0.45 } };
        static double Roof(double x, double y) => 6 + 1.5 * Angle.Sin(6 * (x + y));
        var part = CurvedSolids.Between(CurvedSolids.Plan(95, 95, 125, 125), 40, (_, _) => 0, Roof);
        var slices = CurvedSlicer.Slice([new NamedMesh("part", part)], LayerField.Vertical(PlanSurface.Of(Roof, 3), new LayerBlend(1, 6)), setup).OrThrow();
        var planned = Planner.Plan(slices.ToSteps(), setup).OrThrow();
        var decoded = GCodeDecoder.Decode(SafeWriter.ToDocument(planned, setup).OrThrow()).OrThrow().Toolpath;
        var (wanted, found) = (Prints(planned), Prints(decoded));
        Assert.That(found, Has.Length.EqualTo(wanted.Length));
        for (var i = 0; i < found.Length; i++)
        {
            Assert.That(found[i].End.DistanceTo(wanted[i].End), Is.LessThan(1e-3));
            Assert.That(found[i].End.Z, Is.GreaterThan(0));
        }
        Assert.That(wanted.Select(m => m.End.Z).Distinct().Count(), Is.GreaterThan(1000), "The layers are curved.");
    }

    // Layers of 0.04 to 0.5 mm: those that are too thin are printed several at once, or all of them where that is asked for.
    [TestCase(0)]
    [TestCase(0.001)]
    public void Thin_extrusions_above_each_other_lie_on_each_other_and_not_in_each_others_place(double least)
    {
        static double Roof(double x, double y) => 0.5 + 0.1375 * (x - 90);
        var part = CurvedSolids.Between(CurvedSolids.Plan(90, 100, 130, 112), 20, (_, _) => 0, Roof);
        var setup = new PrintSetup { Settings = CurvedSolids.Massive with { LineWidth = 0.45, CurvedMinGap = least, InfillDensityPercent = 0 } };
        var sliced = CurvedSlicer.Slice([new NamedMesh("part", part)], LayerField.Between(PlanSurface.Level(0), PlanSurface.Of(Roof)), setup);
        Assert.That(sliced.Diagnostics.Any(d => d.Code == "curved.merged_layers"), Is.EqualTo(least == 0));
        var findings = PrintCheck.Run(Planner.Plan(sliced.Value!.ToSteps(), setup).OrThrow(), setup);
        Assert.That(findings.Select(f => f.Code), Has.No.Member(CheckCodes.Duplicate).And.No.Member(CheckCodes.Unsupported));
        var paths = sliced.Value.Layers.SelectMany(l => l.Steps).Select(s => s.Path);
        var heights = paths.SelectMany(p => Enumerable.Range(0, p.SegmentCount).Select(k => p.BeadOf(k).Height));
        Assert.That(heights.Min(), least == 0 ? Is.GreaterThan(0.06) : Is.LessThan(0.05));
    }

    // Layers of 0.05 mm between thick ones, in groups of two. The first group begins with a thick layer, which is not printed again; the last one of the
    // second case ends with one, which is printed with the thin one below it.
    [TestCase(5, 5, new[] { 0.05, 0.1, 0.2 })]
    [TestCase(1, 4, new[] { 0.05, 0.1, 0.2, 0.25 })]
    public void Thin_layers_next_to_thick_ones_are_printed_once(int first, int count, double[] heights)
    {
        double from = 0.2 * first, to = from + 0.05 * count;
        var field = LayerField.Of(p => p.Z < from ? p.Z : p.Z < to ? from + 4 * (p.Z - from) : p.Z + 0.15 * count);
        var part = CurvedSolids.Between(CurvedSolids.Plan(0, 0, 20, 12), 1, (_, _) => 0, (_, _) => to + 1);
        var setup = new PrintSetup { Settings = CurvedSolids.Massive with { LayerHeight = 0.2, FirstLayerHeight = 0.2, CurvedMinGap = 0.08 } };
        var paths = CurvedSlicer.Slice([new NamedMesh("part", part)], field, setup).OrThrow().Layers.SelectMany(l => l.Steps).Select(s => s.Path).ToArray();
        var beads = paths.SelectMany(p => Enumerable.Range(0, p.SegmentCount).Select(k => (p.BeadOf(k).Height, Volume: p.BeadOf(k).Area * p.LengthOf(k))));
        Assert.That(beads.Select(b => Math.Round(b.Height, 3)).Distinct().OrderBy(h => h), Is.EqualTo(heights));
        Assert.That(beads.Sum(b => b.Volume), Is.EqualTo(20 * 12 * (to + 1)).Within(2).Percent);
    }

    private static Move[] Prints(Toolpath toolpath) => toolpath.Moves().Where(m => m.Kind == MoveKind.Print).ToArray();

    [Test]
    public void The_number_of_threads_changes_nothing()
    {
        var part = CurvedSolids.Between(CurvedSolids.Plan(-10, -10, 10, 10), 20, (x, y) => Bowl(x, y) + 1, (x, y) => Bowl(x, y) + 4);
        var field = LayerField.Vertical(PlanSurface.Of(Bowl, 2));
        NamedMesh[] models = [new("part", part)];
        var setup = new PrintSetup { Settings = CurvedSolids.Massive };
        var one = CurvedSlicer.Slice(models, field, setup, new CurvedOptions { Threads = 1 }).OrThrow().ToSteps().Cast<PathStep>().ToArray();
        var many = CurvedSlicer.Slice(models, field, setup, new CurvedOptions { Threads = 4 }).OrThrow().ToSteps().Cast<PathStep>().ToArray();
        Assert.That(many, Has.Length.EqualTo(one.Length));
        for (var i = 0; i < one.Length; i++) Assert.That(many[i].Path.Points, Is.EqualTo(one[i].Path.Points));
    }

    private static Toolpath Decoded(SliceResult slices, PrintSetup setup)
    {
        var document = SafeWriter.ToDocument(Planner.Plan(slices.ToSteps(), setup).OrThrow(), setup).OrThrow();
        return GCodeDecoder.Decode(document).OrThrow().Toolpath;
    }
}
