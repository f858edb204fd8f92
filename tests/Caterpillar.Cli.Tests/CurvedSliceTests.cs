using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using System.Text;
using Caterpillar.Basics;
using Caterpillar.Geometry;
using NUnit.Framework;

namespace Caterpillar.Cli.Tests;

public class CurvedSliceTests : CliFixture
{
    [TestCase("--surface", "0.1 * x")]
    [TestCase("--deform", "cone=10")]
    [TestCase("--deform", "x; y; z + 0.1 * x")]
    public void A_model_is_sliced_along_a_formula_or_a_cone_and_its_moves_change_Z(string option, string value)
    {
        File.WriteAllText("part.stl", Box(20, 10, 3));
        var run = Run("slice", "part.stl", option, value, "--set", "layer_height_mm=0.3");
        Assert.That(run.Code, Is.Zero, run.Messages);
        var prints = File.ReadAllLines("part.gcode").Where(l => l.StartsWith("G1 ") && l.Contains(" X") && l.Contains(" Z") && l.Contains(" E"));
        Assert.That(prints.Count(), Is.GreaterThan(200));
    }

    [Test]
    public void Options_that_do_not_go_together_are_wrong_usage()
    {
        File.WriteAllText("part.stl", Box(20, 10, 3));
        Assert.That(Run("slice", "part.stl", "--field", "vertical").Code, Is.EqualTo(2));
        Assert.That(Run("slice", "part.stl", "--surface", "x", "--deform", "cone=20").Code, Is.EqualTo(2));
        Assert.That(Run("slice", "part.stl", "--field", "z", "--blend", "3").Code, Is.EqualTo(2));
        Assert.That(Run("slice", "part.stl", "--deform", "x; y; z", "--copies", "2").Code, Is.EqualTo(2));
        Assert.That(Run("slice", "part.stl", "--surface", "0.1 * x", "--rotate", "90,0,0").Code, Is.EqualTo(2));
        Assert.That(Run("slice", "part.stl", "--field", "z +").Code, Is.EqualTo(2));
        var both = Run("slice", "part.stl", "--field", "smooth", "--surface", "x");
        Assert.That((both.Code, both.Messages.Contains("--field smooth cannot be combined with --surface.")), Is.EqualTo((2, true)));
    }

    [TestCase("--surface", "0.1 * x + 0.05 * y", "0.1 * y + 0.05 * (20 - x)")]
    [TestCase("--surface", "roof.stl", "large.stl")]
    [TestCase("--field", "z - 0.1 * x", "z - 0.1 * y")]
    [TestCase("--onto", "roof.stl", "large.stl")]
    public void Surfaces_are_scaled_and_rotated_with_the_model(string option, string before, string after)
    {
        File.WriteAllText("part.stl", Box(20, 10, 3));
        // Twice as large, turned from X to Y.
        File.WriteAllText("big.stl", Box(20, 40, 6));
        File.WriteAllText("roof.stl", Tetrahedron((-20, -20, 0), (60, -20, 0), (-20, 40, 0), (10, 5, 1.5)));
        File.WriteAllText("large.stl", Tetrahedron((60, -40, 0), (60, 120, 0), (-60, -40, 0), (10, 20, 3)));
        string[] common = ["--set", "layer_height_mm=0.3", "--set", "resolution_mm=0"];
        var placed = Run(["slice", "part.stl", option, before, "--scale", "2", "--rotate", "90", "-o", "placed.gcode", .. common]);
        var ready = Run(["slice", "big.stl", option, after, "-o", "ready.gcode", .. common]);
        Assert.That((placed.Code, ready.Code), Is.EqualTo((0, 0)), placed.Messages + ready.Messages);
        Assert.That(Extrusion("placed.gcode"), Is.EqualTo(Extrusion("ready.gcode")).Within(2).Percent);
        var ((byX, byY), (alongX, alongY)) = (Slope("placed.gcode"), Slope("ready.gcode"));
        Assert.That((byX - alongX, byY - alongY), Is.EqualTo((0.0, 0.0)).Within(0.002));
        Assert.That(System.Math.Abs(byY), Is.GreaterThan(option == "--onto" || before == "roof.stl" ? 0 : 0.02));
    }

    [Test]
    public void Copies_take_their_surface_and_object_along()
    {
        File.WriteAllText("part.stl", Box(20, 10, 3));
        File.WriteAllText("scan.stl", Box(22, 12, 8));
        var one = Run("slice", "part.stl", "--surface", "0.1 * x", "-o", "one.gcode", "--set", "skirt_loops=0");
        var two = Run("slice", "part.stl", "--surface", "0.1 * x", "--copies", "2", "-o", "two.gcode", "--set", "skirt_loops=0");
        Assert.That((one.Code, two.Code), Is.EqualTo((0, 0)), one.Messages + two.Messages);
        Assert.That(Extrusion("two.gcode"), Is.EqualTo(2 * Extrusion("one.gcode")).Within(0.2).Percent);
        var apart = Run("slice", "part.stl", "--onto", "scan.stl", "--copies", "2", "--spacing", "8", "--partial");
        Assert.That(apart.Code, Is.Zero, apart.Messages);
        var near = Run("slice", "part.stl", "--onto", "scan.stl", "--copies", "2", "--spacing", "1", "--partial");
        Assert.That((near.Code, near.Messages.Contains("Increase --spacing")), Is.EqualTo((2, true)), near.Messages);
    }

    [Test]
    public void Smooth_layers_need_no_surface_and_level_parts_none_of_them()
    {
        File.WriteAllText("part.stl", Box(20, 10, 3));
        var run = Run("slice", "part.stl", "--field", "smooth");
        Assert.That(run.Code, Is.Zero, run.Messages);
        Assert.That(run.Messages, Does.Contain("curved.smooth_level"));
    }

    [Test]
    public void Layers_too_steep_for_the_head_are_refused_and_nothing_is_written()
    {
        File.WriteAllText("part.stl", Box(20, 10, 3));
        var run = Run("slice", "part.stl", "--surface", "2 * x");
        Assert.That(run.Code, Is.EqualTo(1));
        Assert.That(run.Messages, Does.Contain("curved.too_steep"));
        Assert.That(Files(), Is.EqualTo(new[] { "part.stl" }));
    }

    [Test]
    public void On_an_object_the_head_rises_before_it_goes_there_and_prints_above_its_surface()
    {
        File.WriteAllText("plate.stl", Box(10, 6, 0.4));
        File.WriteAllText("scan.stl", Box(20, 10, 8));
        var run = Run("slice", "plate.stl", "--onto", "scan.stl", "--partial");
        Assert.That(run.Code, Is.Zero, run.Messages);
        Assert.That(run.Messages, Does.Contain("curved.object_place"));
        var text = File.ReadAllText("plate.gcode");
        Assert.That(text, Does.Contain("G0 Z8.6 F600"));
        Assert.That(text, Does.Contain(" Z8.2").And.Contain(" Z8.4"));
    }

    [Test]
    public void Layers_between_the_ends_of_a_model_are_found_or_given()
    {
        File.WriteAllText("part.stl", Box(10, 10, 4));
        File.WriteAllText("top.csv", "x,y,z\n0,0,4\n10,0,4\n10,10,4\n0,10,4\n0,0,4\n");
        foreach (var field in new[] { "between", "geodesic" })
        {
            var run = Run("slice", "part.stl", "--field", field, "--set", "layer_height_mm=0.4");
            Assert.That(run.Code, Is.Zero, run.Messages);
        }
        Assert.That(Run("slice", "part.stl", "--field", "harmonic", "--from", "top.csv").Code, Is.EqualTo(2), "--from goes with --to");
        Assert.That(Run("slice", "part.stl", "--surface", "5", "--to", "top.csv").Code, Is.EqualTo(2));
        File.WriteAllText("far.csv", "x,y,z\n50,0,4\n60,0,4\n");
        var missed = Run("slice", "part.stl", "--field", "harmonic", "--to", "far.csv");
        Assert.That((missed.Code, missed.Messages), Is.EqualTo((1, missed.Messages)));
        Assert.That(missed.Messages, Does.Contain("curved.no_boundary"));
    }

    [TestCase("[0, 1, 2, 3]", "[4, 5, 6, 7]", "")]
    [TestCase("[0, 1, 2, 3]", "[4, 5, 6, 8]", "boundary 1 touches no vertex")]
    [TestCase("[0, -1]", "[4, 5, 6, 7]", "The boundaries touch no vertex of the part.")]
    [TestCase("[0, 1, 2, 3]", "[0, 3]", "meet")]
    [TestCase("[0, 1, 2, 3]", "[4.5]", "curves.")]
    [TestCase("[0, 1, 2, 3]", "[]", "curves.")]
    [TestCase("[0, 1, 2, 3]", "[4, 99999999999999999999]", "curves.")]
    public void Boundaries_may_be_lists_of_vertices(string from, string to, string message)
    {
        File.WriteAllText("part.stl", Box(10, 10, 4));
        File.WriteAllText("from.json", from);
        File.WriteAllText("to.JSON", to);
        var run = Run("slice", "part.stl", "--field", "geodesic", "--from", "from.json", "--to", "to.JSON", "-o", "given.gcode");
        Assert.That(run.Code, Is.EqualTo(message.Length == 0 ? 0 : 1), run.Messages);
        Assert.That(run.Messages, Does.Contain(message));
        if (message.Length > 0) return;
        // Both ends of the box are what is found without them.
        Run("slice", "part.stl", "--field", "geodesic", "-o", "found.gcode");
        Assert.That(Code("given.gcode"), Is.EqualTo(Code("found.gcode")));
    }

    [TestCase("edge:1", "edge:2", 0, "")]
    [TestCase("edge:1", "edge:3", 1, "boundary 1 touches no vertex")]
    [TestCase("edge:2", "edge:2", 1, "meet")]
    [TestCase("edge:0", "edge:2", 2, "edge:N needs a number from 1.")]
    [TestCase("edge:1", "edge:1.5", 2, "edge:N needs a number from 1.")]
    [TestCase("edge:1", "edge:", 2, "edge:N needs a number from 1.")]
    public void Boundaries_may_be_open_edges_from_the_longest(string from, string to, int code, string message)
    {
        // A tube that is wider below.
        var text = new StringBuilder("solid tube\n");
        for (var i = 0; i < 16; i++)
        {
            Vec3 At(int k, double radius, double z) => new(radius * Angle.Cos(22.5 * k), radius * Angle.Sin(22.5 * k), z);
            foreach (var face in new[] { new[] { At(i, 6, 0), At(i + 1, 6, 0), At(i + 1, 5, 4) }, [At(i, 6, 0), At(i + 1, 5, 4), At(i, 5, 4)] })
            {
                var corners = string.Concat(face.Select(p => FormattableString.Invariant($"vertex {p.X:R} {p.Y:R} {p.Z:R}\n")));
                text.Append("facet normal 0 0 0\nouter loop\n").Append(corners).Append("endloop\nendfacet\n");
            }
        }
        File.WriteAllText("tube.stl", text.Append("endsolid tube\n").ToString());
        var run = Run("slice", "tube.stl", "--field", "geodesic", "--from", from, "--to", to, "-o", "given.gcode");
        Assert.That(run.Code, Is.EqualTo(code), run.Messages);
        Assert.That(run.Messages, Does.Contain(message));
        if (code != 0) return;
        Run("slice", "tube.stl", "--field", "geodesic", "-o", "found.gcode");
        Assert.That(Code("given.gcode"), Is.EqualTo(Code("found.gcode")));
    }

    private static IEnumerable<string> Code(string file) => File.ReadLines(file).Where(l => l.StartsWith('G'));

    [Test]
    public void The_tool_tilts_along_the_layers_where_asked()
    {
        File.WriteAllText("part.stl", Box(8, 5, 1));
        Assert.That(Run("slice", "part.stl", "--surface", "0.2 * x", "--tilt", "normal", "--set", Head).Code, Is.Zero);
        Assert.That(File.ReadAllText("part.gcode"), Does.Contain(" B-11.31"), "C need not turn");
        var table = Run("slice", "part.stl", "--surface", "0.2 * x", "--tilt", "normal", "--max-tilt", "5", "--set", "rotary_axes=A work x,C work z");
        Assert.That(table.Code, Is.Zero);
        Assert.That(File.ReadAllText("part.gcode"), Does.Contain(" A5 C-90"));
        Assert.That(Run("slice", "part.stl", "--tilt", "from=110,110,-60", "--set", Head).Code, Is.Zero);
        Assert.That(Run("slice", "part.stl", "--tilt", "0; -0.1; 1", "--set", Head).Code, Is.Zero);
        foreach (var wrong in new[] { "bc", "toward=1,2", "normal", "1; 2", "x; y; +" })
            Assert.That(Run("slice", "part.stl", "--tilt", wrong, "--set", Head).Code, Is.Not.Zero, wrong);
        Assert.That(Run("slice", "part.stl", "--surface", "0.2 * x", "--tilt", "normal").Messages, Does.Contain("no axis that tilts"));
        Assert.That(Run("slice", "part.stl", "--max-tilt", "5").Code, Is.EqualTo(2));
    }

    private const string Head = "rotary_axes=C head z,B head y at 0 0 60";

    [Test]
    public void The_table_of_moves_shows_where_a_tilted_tool_points()
    {
        File.WriteAllText("part.stl", Box(20, 12, 3));
        string[][] Rows(params string[] more)
        {
            var run = Run(["slice", "part.stl", "--surface", "0.2 * x", "--set", "layer_height_mm=0.3", "-o", "part.gcode", .. more]);
            Assert.That(run.Code, Is.Zero, run.Messages);
            return Run("decode", "part.gcode", "--csv").Text.Split('\n').Where(l => l.Length > 0).Select(l => l.Split(',')).ToArray();
        }
        Assert.That(Rows()[0], Does.Not.Contain("tool_z"));
        var rows = Rows("--tilt", "normal", "--set", Head);
        Assert.That(rows[0].Skip(rows[0].Length - 6), Is.EqualTo(new[] { "a_deg", "b_deg", "c_deg", "tool_x", "tool_y", "tool_z" }));
        Assert.That(rows.Select(r => r.Length).Distinct().Count(), Is.EqualTo(1));
        var printed = rows.First(r => r[2] == "print" && r[^5] == "-11.31");
        Assert.That(printed.Skip(printed.Length - 3).Select(double.Parse), Is.EqualTo(new[] { -0.196116, 0, 0.980581 }).Within(1e-5));
    }

    [Test]
    public void Curves_and_turtles_are_put_onto_an_object()
    {
        File.WriteAllText("scan.stl", BoxAt(180, 180, 8, 30));
        File.WriteAllText("lines.csv", "x,y,z\n50,40,0.2\n90,40,0.2\n90,45,0.2\n");
        File.WriteAllText("square.turtle", "start 50 50 0.2\npen_up\nforward 5\npen_down\nforward 10\nleft 90\nforward 10\n");
        var run = Run("curves", "lines.csv", "--onto", "scan.stl", "--squeeze", "0.05");
        Assert.That(run.Code, Is.Zero, run.Messages);
        Assert.That(run.Messages, Does.Contain("curved.object_place"));
        Assert.That(File.ReadAllText("lines.gcode"), Does.Contain("Z8.15"));
        Assert.That(run.Messages, Does.Not.Contain("extrusion.unsupported"), "the object is there");
        Assert.That(Run("check", "lines.gcode").Text, Does.Contain("extrusion.unsupported"));
        Assert.That(Run("check", "lines.gcode", "--onto", "scan.stl").Text, Does.Not.Contain("extrusion.unsupported"));
        File.WriteAllText("higher.stl", BoxAt(180, 180, 9, 30));
        var blocked = Run("check", "lines.gcode", "--onto", "higher.stl");
        Assert.That(blocked.Code, Is.EqualTo(3));
        Assert.That(blocked.Text, Does.Contain("collision.nozzle").And.Contain("the object below the print"));
        run = Run("turtle", "square.turtle", "--onto", "scan.stl", "--plan", "printer");
        Assert.That(run.Code, Is.Zero, run.Messages);
        Assert.That(File.ReadAllText("square.gcode"), Does.Contain("Z8"));
        Assert.That(Run("curves", "lines.csv", "--squeeze", "0.1").Code, Is.EqualTo(2));
        run = Run("curves", "lines.csv", "--onto", "scan.stl", "--in-place");
        Assert.That(run.Messages, Does.Contain("collision.nozzle"), "the lines stay below the top of the object");
        Assert.That(Run("curves", "lines.csv", "--in-place").Messages, Does.Contain("--in-place needs --onto"));
        Assert.That(Run("curves", "lines.csv", "--onto", "scan.stl", "--in-place", "--partial").Code, Is.EqualTo(2));
    }

    // How much extrusions rise along X and along Y.
    private static (double ByX, double ByY) Slope(string file)
    {
        double x = 0, y = 0, z = 0, byX = 0, byY = 0, all = 0;
        foreach (var line in File.ReadAllLines(file).Where(l => l.StartsWith("G1 ") || l.StartsWith("G0 ")))
        {
            var words = line.Split(';')[0].Split(' ', System.StringSplitOptions.RemoveEmptyEntries);
            double To(char letter, double from) => words.FirstOrDefault(w => w[0] == letter) is { } word
                ? double.Parse(word[1..], System.Globalization.CultureInfo.InvariantCulture) : from;
            var (nextX, nextY, nextZ) = (To('X', x), To('Y', y), To('Z', z));
            var (alongX, alongY) = (nextX - x, nextY - y);
            if (To('E', 0) > 0) (byX, byY, all) = (byX + alongX * (nextZ - z), byY + alongY * (nextZ - z), all + alongX * alongX + alongY * alongY);
            (x, y, z) = (nextX, nextY, nextZ);
        }
        return (byX / all, byY / all);
    }

    // mm of filament.
    private static double Extrusion(string file)
        => File.ReadAllLines(file).Where(l => l.StartsWith("G1 ") && l.Contains(" X") && l.Contains(" E"))
            .Sum(l => double.Parse(l.Split(' ').First(w => w.StartsWith('E'))[1..], System.Globalization.CultureInfo.InvariantCulture));

    private static string Tetrahedron(params (double X, double Y, double Z)[] p)
    {
        var text = new System.Text.StringBuilder("solid roof\n");
        foreach (var face in new[] { "021", "013", "123", "203" })
        {
            text.Append("facet normal 0 0 0\nouter loop\n");
            foreach (var (x, y, z) in face.Select(c => p[c - '0'])) text.Append(System.FormattableString.Invariant($"vertex {x} {y} {z}\n"));
            text.Append("endloop\nendfacet\n");
        }
        return text.Append("endsolid roof\n").ToString();
    }
}
