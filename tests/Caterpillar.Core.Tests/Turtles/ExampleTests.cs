using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using System.Numerics;
using Caterpillar.Basics;
using Caterpillar.Checks;
using Caterpillar.GCode;
using Caterpillar.Geometry;
using Caterpillar.Machines;
using Caterpillar.Planning;
using Caterpillar.Toolpaths;
using Caterpillar.Turtles;
using NUnit.Framework;

namespace Caterpillar.Tests.Turtles;

/// <summary>Every program of examples/turtle against segments, end and filament computed by hand from its recipe.</summary>
internal sealed class ExampleTests
{
    // mm² of 1.75 mm filament.
    private const double Filament = Math.PI * 0.875 * 0.875;

    private const double Kanada = 0.196 / Filament;

    private static string Folder => Path.Combine(TestData.Repository, "examples", "turtle");

    public static IEnumerable<string> SomeNames => Rounds.Some(Names, 3);

    public static IEnumerable<string> Names
        => Directory.GetFiles(Folder, "*.turtle").Select(f => Path.GetFileNameWithoutExtension(f)!).OrderBy(n => n, StringComparer.Ordinal);

    public static Turtle Run(string name, int seed = 0)
    {
        var file = Path.Combine(Folder, name + ".turtle");
        var script = TurtleScript.Compile(File.ReadAllText(file), name, new ScriptFiles(Folder));
        Assert.That(script.Diagnostics, Is.Empty);
        var run = script.Value!.Run(seed: seed);
        Assert.That(run.Diagnostics.Where(d => d.Code != TurtleScript.PrintCode), Is.Empty);
        return run.Value!;
    }

    // Once for the tests that only read what is drawn.
    private static readonly Dictionary<string, Turtle> Drawn = new();

    private static Turtle Once(string name)
    {
        lock (Drawn)
        {
            if (!Drawn.TryGetValue(name, out var turtle)) Drawn.Add(name, turtle = Run(name));
            return turtle;
        }
    }

    [Category("Arithmetic")]
    [TestCaseSource(nameof(Names))]
    public void Programs_give_what_their_recipes_say(string name)
    {
        Assert.That(Expected.Keys, Does.Contain(name), "every program has its formula");
        var expected = Expected[name];
        var turtle = Once(name);
        var totals = CommandList.Total(turtle, default);
        Assert.That(File.ReadLines(Path.Combine(Folder, name + ".turtle")).First(), Does.StartWith("# "),
            "the first comment states what the recipe leaves open");
        Assert.That(turtle.ToSteps().OfType<PathStep>().Sum(p => p.Path.SegmentCount), expected.Segments, "segments");
        if (expected.End is { } end) Assert.That(turtle.Position.DistanceTo(end), Is.LessThan(1e-8), $"end {turtle.Position}");
        if (expected.Z is { } z) Assert.That(turtle.Z, Is.EqualTo(z).Within(1e-9), "height");
        if (expected.FilamentOf is { } e) Assert.That(totals.EPrint + totals.EExtrude, Is.EqualTo(e(totals.PrintMoves)).Within(1e-8), "mm of filament");
    }

    [TestCaseSource(nameof(Names))]
    [Category("Arithmetic")]
    public void Programs_fit_the_printer_that_they_name_or_the_default_one(string name)
    {
        var script = TurtleScript.Compile(File.ReadAllText(Path.Combine(Folder, name + ".turtle")), name, new ScriptFiles(Folder)).OrThrow();
        var profiles = script.Profiles;
        var (printer, material, settings) = (profiles.ElementAtOrDefault(0), profiles.ElementAtOrDefault(1), profiles.ElementAtOrDefault(2));
        var setup = new ProfileLibrary().Setup(printer ?? "generic", material, settings).OrThrow();
        var turtle = script.Run(new TurtleOptions { Extrusion = setup.Extrusion, Shape = setup.Settings.BeadShape }).OrThrow();
        var plan = Planner.Plan(turtle.ToSteps(), setup, new PlanOptions { Policy = PlanPolicy.AsDrawn }).OrThrow();
        var findings = SafeWriter.ToDocument(plan, setup).Diagnostics
            .Where(d => d.Severity != Severity.Note && CheckCodes.Find(d.Code) is not null).ToArray();
        var errors = findings.Where(d => d.Severity == Severity.Error);
        Assert.That(errors, Is.Empty);
        // A program that the checks warn of says of what.
        var comment = script.Text.Split('\n').SingleOrDefault(l => l.StartsWith("# The checks ", StringComparison.Ordinal)) ?? "";
        var named = CheckCodes.All.Select(r => r.Code).Where(comment.Contains);
        Assert.That(findings.Except(errors).Select(d => d.Code).Distinct(), Is.EquivalentTo(named), comment);
    }

    private static Dictionary<string, Recipe> Expected { get; } = new()
    {
        ["seven_star"] = Of(30 * 7, At(9.3), 30 * 7 * 50 * 0.05),
        ["bumpy_star"] = Of(9 * 7, At(1 + 9 * 1.2), 9 * 7 * 50 * 0.3),
        ["tall_bumpy_star"] = Of(50 * 7, At(0.6 + 50 * 0.6), 50 * 7 * 50 * 0.2),
        // Heights of x and -x cancel; a step is sqrt(1 + climb²) long.
        ["nonplanar_star"] = Of(30 * 7 * 51, At(0.15 + 30 * 0.15), 0.05 * 7 * Sum(0, 29, l => Sum(-25, 25, x => Hypot(1, l / 30 * (x / 25) * 0.3)))),
        ["nonplanar_column"] = Of(100 * 100, At(0.25 + 100 * 0.25),
            0.05 * Sum(0, 99, l => Sum(0, 99, k => Hypot(40 * Math.PI / 100, 18 * Math.Min(l / 20, 1) * Sin(10.8 * k) / 100)))),
        // The circles close; the length of the spiral remains, whose first step has no length.
        ["nonplanar_vase"] = Of(3999 + 200 * 100, Walk(0.5 + 200 * 0.25, 0, 3999, k => k * 0.005 * 2 * Math.PI / 100, -3.6),
            0.05 * (0.005 * 2 * Math.PI / 100 * 3999 * 4000 / 2
                + Sum(0, 199, l => Sum(0, 99, k => Hypot(2 * Math.PI * VaseRadius(l) / 100, 18 * Math.Min(l / 20, 1) * Sin(10.8 * k) / 100))))),
        ["nonplanar_bump"] = Of(10 * 2400, At(0.15 + 20 * 0.15),
            0.05 * 2 * Sum(0, 9, l => 1200 * 1201 / 2.0 / 60 * Hypot(2 * Math.PI / 30, l / 10 * 12 / 23980))),
        ["spiral"] = Of(6000, Walk(0.2, 0, 5999, k => (30 - 0.005 * k) * 2 * Math.PI / 100, -3.6),
            0.05 * 2 * Math.PI / 100 * (30 * 6000 - 0.005 * 5999 * 6000 / 2)),
        // The 66 · 8 chords go 8 times through all n from 1 to 66; the sum of sin(n π / N) is cot(π / 2N).
        ["cardioid"] = Of(66 * (67 + 8), At(0.3 + 66 * 0.3), 0.07 * 66 * 67 * 50 * Sin(180 / 67.0) + 0.03 * 8 * 50 / Math.Tan(Math.PI / 134)),
        ["not_a_cardioid"] = Of(78 * (79 + 10), At(0.3 + 78 * 0.3), 0.07 * 78 * 79 * 50 * Sin(180 / 79.0) + 0.03 * 10 * 50 / Math.Tan(Math.PI / 158)),
        ["complex_walk"] = Of(30 * 224, At(0.3 + 30 * 0.3), 30 * 224 * 2 * 0.05),
        ["dreamcatcher"] = new Recipe(Is.EqualTo(50 * 101), null, 0.3 + 50 * 0.3, null),
        ["koch_snowflake"] = Of(40 * 3 * 1024, At(0.3 + 40 * 0.3), 40 * 3 * 1024 * 50 / 243.0 * 0.05),
        // 3 · 4^g sides of four moves; in the first layer of a generation two of them have no length. A side's moves are side + gap long.
        ["evolving_snowflake"] = Of(4 * 3 * 85 * 40 - 2 * 3 * 85, At(0.3 + 160 * 0.3),
            0.05 * Sum(0, 3, g => 3 * Math.Pow(4, g) * Sum(0, 39, l => 50 / Math.Pow(3, g) * (1 + l / 40 / 3)))),
        ["hilbert"] = Of(20 * 1023, new Vec3(60, 60, 0.3 + 20 * 0.3), 20 * 1023 * 2 * 0.05),
        ["pine_tree"] = Of(1600 + 60 * 20, Walk(0.2 + 650 * 0.05, 0, 1599, PineBase, -9),
            0.05 * (Sum(0, 1599, PineBase) + 20 * Sum(0, 59, l => 15 * (1 - l / 60))) + 650 * 0.1),
        ["palm_tree"] = Of(1600 + 59 * 20, PalmEnd(), 0.06 * (Sum(0, 1599, PineBase) + 20 * Sum(0, 59, l => 20 * Math.Pow(l / 60, 4))) + 650 * 0.1),
        // Bumps of two moves of 1 mm, as many as there are more segments than sides.
        ["braille_bumps"] = Random(Is.InRange(2500 + 2 * 300, 2500 + 2 * 500).And.Matches<int>(n => n % 2 == 0), At(15.3),
            n => 0.03 * (2500 * 40 * Sin(3.6) + (n - 2500))),
        ["braille_gradient"] = Random(Is.InRange(20000 + 2 * 1700, 20000 + 2 * 2300).And.Matches<int>(n => n % 2 == 0), At(30.3),
            n => 0.06 * (20000 * 40 * Sin(0.9) + (n - 20000))),
        ["braille_directed"] = Of(2500, At(15.3), 0.06 * 2500 * 40 * Sin(3.6)),
        ["braille_rule30"] = Of(3000 + 2 * Rule30(20, 3), At(18.3), 0.06 * (3000 * 40 * Sin(3.6) + 2 * Rule30(20, 3))),
        ["circle_by_chords"] = Of(360, At(2.2), 0.05 * 360 * 40 * Sin(5)),
        ["hair_pillar"] = Of(160, new Vec3(105, 105, 12.3), 0.05 * 1600 + 80 * 0.5),
        // The spiral comes back to its start; the walk over 10, 9, … 1 dots makes half turns, so x ends 2 (5 · 1 + …) apart.
        ["hair_patch"] = Of(6 * 64, PatchEnd(), 0.05 * 6 * 2 * Sum(0, 31, k => 22 - 0.7 * k) + 110 * 0.4),
        ["horizontal_brush"] = Of(20 * 8 + 5 * 20, new Vec3(60, 100, 5.25), 0.05 * 20 * 96 + 0.02 * 100 * 80 + 100 * 0.3),
        ["hair_bridge"] = Of(20 * 8 + 5 * 20, At(5.25), 0.05 * 20 * 96 + 0.02 * 100 * 64),
        ["gappy_prism"] = Of(50 * 5 * 2, new Vec3(90, 90, 15.3), 0.06 * 50 * 5 * 24),
        ["random_hourglass"] = new Recipe(Is.EqualTo(1680), null, 0.2 + 1680 * 0.2 / 7,
            _ => 0.04 * Sum(0, 1679, l => 10 * Math.Sqrt(12 * Math.Pow(l / 1680 - 0.5, 2) + 1)) + 1680 * 0.4),
        ["random_polygon"] = new Recipe(Is.EqualTo(420), null, 0.3 + 420 * 0.3 / 7, _ => 0.02 * 420 * 20 + 420 * 0.8),
        ["feedrate_test"] = Of(800, At(60.3), 800 * 30 * 0.05),
        ["kanada_cylinder"] = Of(1152, At(0.4 + 16 * 0.4), 1152 * Hypot(1, 0.4 / 72) * Kanada),
        ["kanada_pyramid"] = Of(300, Walk(0.4 + 30, 0, 299, j => 30 - 0.1 * j, 90.5, 45, 100, 90), Sum(0, 299, j => Hypot(30 - 0.1 * j, 0.1)) * Kanada),
        // 2^k branches of 30 · 0.75^k for k = 0 to 9 (30 · 0.75^10 is below 2); the last one is the outermost on the right.
        ["kanada_tree"] = Of(1023, Walk(0.4, 0, 9, k => 30 * Math.Pow(0.75, k), -30, 0, 60, 110), 30 * (Math.Pow(1.5, 10) - 1) / 0.5 * Kanada),
        // Rings of the ground have 36 sides, loops of limbs 12. Each generation of limbs has twice as many.
        ["branching_tree"] = Of(15 * 36 + 12 * (60 + 2 * 42 + 4 * 29 + 8 * 20 + 16 * 14 + 32 * 10), TreeEnd(),
            0.035 * (Sum(1, 15, k => 36 * 2 * 0.45 * k * Sin(5)) + Sum(0, 5, g => Math.Pow(2, g) * LimbLayers[(int)g] * 12 * 2 * LimbRadius(g) * Sin(15)))),
        // Radii 30, 31.5, 30, 28.5 in turn, 1.5 degrees apart.
        ["weave_wall"] = Of(20 * 240, new Vec3(130, 100, 21), 20 * 60 * 2 * (Chord(30, 31.5, 1.5) + Chord(30, 28.5, 1.5)) * 2 / Filament),
        ["random_walk_wall"] = new Recipe(Is.EqualTo(20 * 120), null, 21, null),
        ["hexagonal_prism"] = Of(360, At(12.2), 360 * 15 * 0.05),
        ["prism_bottoms"] = Of((33 + 20) * 5 + 101 + 80 + 1440 + 20 * 48, new Vec3(165, 40, 4.2),
            0.05 * (5 * Sum(0, 32, k => 24 - k * Math.Tan(Math.PI / 5)) + 100 * 24 + 51 * 25 + 50 * 0.5 + 80 * 25
                + Sum(1, 1440, k => Chord(k / 96, (k - 1) / 96, 7.5)) + 20 * 48 * 30 * Sin(3.75))),
        ["filled_cube"] = Of(50 * (81 + 41 + 21), new Vec3(140, 110, 10), 0.05 * 50 * (41 * 20 + 20 + 21 * 20 + 20 + 11 * 20 + 20)),
        ["oscillating_circle"] = Of(40 * 360, new Vec3(130, 100, 41), 2 / Filament * Sum(0, 39, n => Sum(1, 360, k => Ring(n, k).DistanceTo(Ring(n, k - 1))))),
        ["textile_circle"] = Of(200 * 200 * 4, At(60.3), 0.01 * 40000 * (80 * Sin(0.9) + 4)),
        ["textile_sheet"] = Of(100 * 48 * 4, new Vec3(80, 100, 30.3), 0.01 * 4800 * (1.25 + 4)),
        ["furry_prism"] = Of(100 * 5 * 46, At(15.15), 0.05 * 100 * 5 * (25 + 30)),
        ["bumpy_prism"] = Of(50 * 6 * 5, At(10.2), 0.05 * 50 * 6 * 24),
        // Two pieces along the edge where x > 0: not in every tenth layer.
        ["string_art_square"] = Of(50 * 11 + 45 * 2, At(0.3 + 50 * 0.9), 0.06 * 150 * (100 + 50 * Math.Sqrt(2))
            + 0.03 * 5 * Sum(0, 9, i => 2 * Hypot(5 * i, 50 - 5 * i) + 10 * i)),
        ["string_art_parabola"] = Of(6 + 72, new Vec3(80, 80, 1.8),
            0.06 * 360 + 0.03 * 3 * Sum(1, 24, k => 60 * Hypot(k / 25 - (1 - k / 25) * 0.5, (1 - k / 25) * Math.Sqrt(0.75)))),
        ["rose"] = Of(20 * 720, new Vec3(130, 100, 6.3), 0.05 * 20 * Sum(1, 720, k => Rose(k).DistanceTo(Rose(k - 1)))),
        ["stretchy_line"] = Of(70, At(3.3), 0.05 * 10 * 64),
        ["curly_line"] = Of(3, new Vec3(160, 140, 3), 300 * 0.2),
        ["pillar_array"] = Of(200, new Vec3(101.25, 121.25, 0.4), 0.05 * 50 * 40.4 + 64 * 0.1),
        // The deformed strings by their own length: cups of 30 and 75 turns, rings, spheres.
        ["kanada_plate"] = Of(30 * 72 + 75 * 72, new Vec3(110, 110, 0.3)),
        ["kanada_sphere"] = Of(72 + (int)Math.Ceiling(Math.PI / 2 * 25 / 0.2 * 72), new Vec3(110, 110, 0.4)),
        ["kanada_globe"] = Of(150 * 300, new Vec3(110, 110, 0.4)),
        ["lamp_shade"] = Of(2 * 72 + 100 * 90, new Vec3(110, 110, 0.4)),
        ["gap_hill"] = new Recipe(Is.InRange(4 * 30 * 30 - 120, 4 * 30 * 30 * 2), new Vec3(125, 109.5, 0.25 + 0.15 * 3), null, null),
        ["cooled_tower"] = Of(60 * 4, new Vec3(110, 110, 0.2 + 60 * 0.2), 0.05 * 4 * Sum(0, 59, n => 12 - 0.1 * n)),
        // A square has a line more than gaps, and a gap between two lines.
        ["calibration_first_layer"] = new Recipe(Is.EqualTo(5 * (68 + 67)), null, 0.2, null),
        ["calibration_flow"] = new Recipe(Is.EqualTo(5 * 4 * (4 + 39)), null, 8, null),
        ["calibration_pressure_advance"] = new Recipe(Is.EqualTo(4 + 21 * 3), null, 0.2, null),
        ["calibration_retraction"] = new Recipe(Is.EqualTo(48 * 2 * (12 + 1 + 159 * 2)), null, 32, null),
        ["calibration_temperature"] = new Recipe(Is.EqualTo(4 * (240 * 2 + 12)), null, 48, null),
        ["parameter_test"] = Of(20 * 100, new Vec3(160, 125, 5.2), 4 * 25 * 80 * (0.02 + 0.035 + 0.05 + 0.065 + 0.08)),
    };

    [Category("Arithmetic")]
    [TestCase("seven_star", "seven_star")]
    [TestCase("bumpy_star", "bumpy_star")]
    [TestCase("tall_bumpy_star", "tall_bumpy_star")]
    [TestCase("nonplanar_star", "nonplanar_star")]
    [TestCase("nonplanar_column", "nonplanar_column")]
    [TestCase("nonplanar_bump", "nonplanar_bump")]
    [TestCase("cardioid", "cardioid")]
    [TestCase("koch_snowflake", "snowflake_lsystem")]
    [TestCase("evolving_snowflake", "evolving_snowflake")]
    [TestCase("palm_tree", "palm_tree")]
    [TestCase("feedrate_test", "feedrate_test")]
    [TestCase("hair_patch", "hair_patch")]
    [TestCase("furry_prism", "furry_prism")]
    [TestCase("string_art_square", "square_string_art")]
    [TestCase("stretchy_line", "stretchy_line")]
    [TestCase("hexagonal_prism", "hexagonal_prism", 0.5)]
    public void Programs_draw_what_the_recorded_lists_draw(string program, string list, double filament = 1)
    {
        var file = TestData.Shared($"turtle/{list}.turtle.txt.gz".Replace(".gz", File.Exists(Path.Combine(TestData.Shared("turtle"), list + ".turtle.txt"))
            ? "" : ".gz"));
        var ours = Prints(Once(program));
        var theirs = Prints(CommandList.Replay(file));
        Assert.That(ours, Has.Count.EqualTo(theirs.Count));
        // Programs may stand higher than the lists, whose first layer is at 0.
        var up = ours[0].From - theirs[0].From;
        Assert.That(up.LengthXY, Is.LessThan(1e-9));
        var worst = ours.Zip(theirs, (a, b) => Math.Max(a.To.DistanceTo(b.To + up), Math.Abs(a.Filament - filament * b.Filament))).Max();
        Assert.That(worst, Is.LessThan(1e-8));
        Assert.That(ours.Zip(theirs, (a, b) => Math.Abs(a.Rate - b.Rate)).Max(), Is.LessThan(1e-8));
    }

    [TestCaseSource(nameof(SomeNames))]
    public void Programs_give_the_same_code_everywhere(string name)
    {
        byte[] Write()
        {
            var plan = Planner.Plan(Run(name).ToSteps(), new PrintSetup(), new PlanOptions { Policy = PlanPolicy.AsDrawn });
            return NewFile.Of(plan.Value!);
        }
        Golden.Check($"turtle/{name}.gcode", Golden.Under("de-DE", Write));
    }

    [Test]
    public void Random_programs_follow_their_seed()
    {
        foreach (var name in new[] { "dreamcatcher", "random_polygon", "braille_bumps" })
        {
            Assert.That(Prints(Run(name, 3)), Is.EqualTo(Prints(Run(name, 3))));
            Assert.That(Prints(Run(name, 3)), Is.Not.EqualTo(Prints(Run(name, 4))));
        }
    }

    private static List<TurtleMove> Prints(Turtle turtle) => TurtleHistory.Of(turtle.ToSteps()).Where(m => m.Prints && m.Length > 1e-9).ToList();

    private static Recipe Of(int segments, Vec3 end) => new(Is.EqualTo(segments), end, null, null);

    private static Recipe Of(int segments, Vec3 end, double filament) => new(Is.EqualTo(segments), end, null, _ => filament);

    private static Recipe Random(NUnit.Framework.Constraints.IResolveConstraint segments, Vec3 end, Func<int, double>? filament = null)
        => new(segments, end, null, filament);

    private static Vec3 At(double z) => new(100, 100, z);

    private static double Sum(int from, int to, Func<double, double> term)
    {
        var sum = 0.0;
        for (var i = from; i <= to; i++) sum += term(i);
        return sum;
    }

    private static double Hypot(double a, double b) => Math.Sqrt(a * a + b * b);

    private static double Sin(double degrees) => Math.Sin(degrees * Math.PI / 180);

    // Between two points at some radii and an angle at the middle.
    private static double Chord(double a, double b, double degrees) => Math.Sqrt(Math.Max(0, a * a + b * b - 2 * a * b * Math.Cos(degrees * Math.PI / 180)));

    // The end of a walk in the plane: the sum of its steps as complex numbers.
    private static Vec3 Walk(double z, int from, int to, Func<double, double> length, double turn, double heading = 0, double x = 100, double y = 100)
    {
        var sum = new Complex(x, y);
        for (var k = from; k <= to; k++) sum += Complex.FromPolarCoordinates(length(k), (heading + turn * (k - from)) * Math.PI / 180);
        return new Vec3(sum.Real, sum.Imaginary, z);
    }

    private static int[] LimbLayers => [60, 42, 29, 20, 14, 10];

    private static double LimbRadius(double generation) => 2.4 * Math.Pow(0.72, generation);

    // The last limb always turns left by 90 degrees. The turtle stands below the center of its loop.
    private static Vec3 TreeEnd()
        => Walk(0.2 + 0.2 * LimbLayers.Sum(), 1, 5,
            g => LimbRadius(g - 1) - LimbRadius(g) + 0.2 * LimbLayers[(int)g] * Math.Tan(35 * Math.PI / 180), 90, 90, 110, 110 - LimbRadius(5));

    private static double PineBase(double k) => (20 - 0.0125 * k) * 2 * Math.PI / 40;

    private static double VaseRadius(double layer) => 20 + Sum(0, (int)layer - 1, n => 20 * Sin(270 * (n / 200 + 1.0 / 3)) / 100);

    // A frond is d (1 + e^30i + e^180i + e^210i) = 0: it closes; the headings do not matter.
    private static Vec3 PalmEnd() => Walk(65.2, 0, 1599, PineBase, -9);

    // Rounds of 10, 9, … 1 dots, 2 mm apart: up and left in turn with headings 90 and 180, then 270 and 0, and so on.
    private static Vec3 PatchEnd()
    {
        var (x, y) = (100.0, 100.0);
        for (var row = 10; row >= 1; row--)
        {
            var sign = row % 2 == 0 ? 1 : -1;
            y += sign * 2 * row;
            x -= sign * 2 * row;
        }
        return new Vec3(x, y, 0.2 + 6 * 0.2 + 10.2);
    }

    private static Vec3 Ring(double layer, double k)
        => new((30 + 3 * Sin(12 * k)) * Sin(k + 90), (30 + 3 * Sin(12 * k)) * Sin(k), 0.6 * Math.Min(layer / 20, 1) * Sin(6 * k));

    private static Vec3 Rose(double k)
        => new(30 * Sin(5 / 3.0 * 540 * k / 720 + 90) * Sin(540 * k / 720 + 90), 30 * Sin(5 / 3.0 * 540 * k / 720 + 90) * Sin(540 * k / 720));

    // Bumps: living cells of every generation, each printed in some layers. Rule 30 is left xor (middle or right).
    private static int Rule30(int generations, int layers)
    {
        var cells = new bool[50];
        cells[25] = true;
        var count = 0;
        for (var g = 0; g < generations; g++)
        {
            count += layers * cells.Count(c => c);
            cells = cells.Select((c, i) => cells[(i + 49) % 50] ^ (c | cells[(i + 1) % 50])).ToArray();
        }
        return count;
    }

    private sealed record Recipe(NUnit.Framework.Constraints.IResolveConstraint Segments, Vec3? End, double? Z, Func<int, double>? FilamentOf);
}
