using System;
using System.Linq;
using Caterpillar.Basics;
using Caterpillar.Drawings;
using Caterpillar.Geometry;
using Caterpillar.Toolpaths;
using NUnit.Framework;

namespace Caterpillar.Tests.Curves;

/// <summary>Curves of JSON and OBJ at their limits.</summary>
public class JsonEdgeTests
{
    [TestCase("{\"center\":[1,2],\"radius\":3}", 6 * Math.PI)]
    [TestCase("{\"units\":\"cm\",\"center\":[1,2],\"radius\":3}", 60 * Math.PI)]
    [TestCase("{\"units\":\"inch\",\"points\":[[0,0],[1,0]]}", 25.4)]
    [TestCase("{\"units\":\"m\",\"points\":[[0,0],[1,0]]}", 1000)]
    [TestCase("{\"center\":[1,2],\"radius\":3,\"start\":90,\"sweep\":-180}", 3 * Math.PI)]
    [TestCase("[[0,0],[3,4]]", 5)]
    [TestCase("[{\"x\":0,\"y\":0},{\"x\":3,\"y\":4,\"z\":12}]", 13)]
    [TestCase("{\"points\":[[0,0],[3,0],[3,4]],\"closed\":true}", 12)]
    [TestCase("{\"points\":[[0,0],[3,0],[3,4]],\"closed\":false}", 7)]
    [TestCase("{\"degree\":1,\"points\":[[0,0],[3,0],[3,4]]}", 7)]
    public void Curves_of_all_kinds_have_their_length(string text, double length)
        => Assert.That(Read(text).Value!.Single().Curve.Length, Is.EqualTo(length).Within(1e-9));

    [TestCase("\"tool\":1000", null)]
    [TestCase("\"tool\":1001", "curves.json")]
    [TestCase("\"tool\":-1", "curves.json")]
    [TestCase("\"layer\":-100000000", null)]
    [TestCase("\"layer\":100000001", "curves.json")]
    [TestCase("\"layer\":-100000001", "curves.json")]
    [TestCase("\"dot\":-1", "curves.json")]
    [TestCase("\"dot\":0", null)]
    [TestCase("\"width\":0", null)]
    [TestCase("\"width\":-0.1", "curves.bead")]
    [TestCase("\"width\":\"%\"", "curves.number")]
    [TestCase("\"width\":\"50%\"", "curves.percent")]
    [TestCase("\"flow\":\"50 %\"", null)]
    [TestCase("\"units\":\"ft\"", "curves.json")]
    public void Settings_have_their_ranges(string setting, string? error)
        => Assert.That(Read("{\"points\":[[0,0],[1,0]]," + setting + "}").Diagnostics.FirstOrDefault()?.Code, Is.EqualTo(error));

    [TestCase(64, 65, null)]
    [TestCase(65, 66, "curves.json")]
    [TestCase(0, 3, "curves.json")]
    public void Degrees_are_1_to_64(int degree, int points, string? error)
    {
        var list = string.Join(",", Enumerable.Range(0, points).Select(i => $"[{i},{i % 2}]"));
        Assert.That(Read($"{{\"degree\":{degree},\"points\":[{list}]}}").Diagnostics.FirstOrDefault()?.Code, Is.EqualTo(error));
    }

    [TestCase(9, null)]
    [TestCase(10, "curves.json")]
    public void Pieces_are_nested_at_most_nine_deep(int depth, string? error)
    {
        var text = string.Concat(Enumerable.Repeat("{\"pieces\":[", depth)) + "[[0,0],[1,0]]" + string.Concat(Enumerable.Repeat("]}", depth));
        Assert.That(Read(text).Diagnostics.FirstOrDefault()?.Code, Is.EqualTo(error));
    }

    [TestCase("[[0,0],[1,0]] 5", "Additional text encountered after finished reading JSON content: 5.")]
    [TestCase("[[0,0],[1,0]] /* end */ /* */", null)]
    [TestCase("{\"points\":[[0,0],[1]]}", "A point must be a list of two or three numbers, or an object with x and y.")]
    [TestCase("{\"points\":[[0,0],[1,2,3,4]]}", "A point must be a list of two or three numbers, or an object with x and y.")]
    [TestCase("{\"points\":[{\"x\":0,\"y\":0,\"width\":1},{\"x\":1,\"y\":0}]}", "Either all points of a curve must have \"width\", or none.")]
    [TestCase("{\"center\":[0,0]}", "The \"radius\" is missing.")]
    [TestCase("{\"degree\":2,\"points\":[[0,0],[1,0],[1,1]],\"weights\":1}", "Expected a list of numbers.")]
    [TestCase("{\"curves\":5}", "Expected a list of points, a list of curves, or an object with \"curves\".")]
    [TestCase("{}", "A curve needs \"points\", \"center\" or \"pieces\".")]
    [TestCase("[5]", "A curve must be a list of points or an object.")]
    public void Wrong_data_are_errors_in_a_sentence(string text, string? message)
        => Assert.That(Read(text).Diagnostics.FirstOrDefault()?.Message, Is.EqualTo(message));

    [TestCase(30)]
    [TestCase(31)]
    public void Unknown_keys_are_shown_by_their_first_letters(int length)
    {
        var message = Read("{\"points\":[[0,0],[1,0]],\"" + new string('q', length) + "\":1}").Diagnostics.Single().Message;
        Assert.That(message, Does.Contain("\"" + new string('q', 30) + "\""));
    }

    [Test]
    public void Settings_of_the_whole_hold_for_curves_that_state_none()
    {
        var curves = Read("{\"width\":1,\"speed\":5,\"curves\":[{\"points\":[[0,0],[1,0]],\"width\":2,\"height\":0.3,\"area\":4},[[0,0],[1,0]]]}").Value!;
        Assert.That(curves.Select(c => (c.Width, c.Speed, c.Height, c.Area)),
            Is.EqualTo(new (double?, double?, double?, double?)[] { (2, 5, 0.3, 4), (1, 5, null, null) }));
    }

    [TestCase("v 0 0 0\nv 1 0 0\nl 0 1\nl x\n", "3:3: error curves.obj: A line uses vertex 0, which is not defined before it.")]
    [TestCase("v 0 0 0\nv 1 0 0\nl 1 3\nl x\n", "3:5: error curves.obj: A line uses vertex 3, which is not defined before it.")]
    [TestCase("v 0 0 0\nv 1 0 0\nl -1 -3\n", "3:6: error curves.obj: A line uses vertex -3, which is not defined before it.")]
    [TestCase("v 0 0 0\nl 1.5 1\nl x\n", "2:3: error curves.obj: The points of a line must be vertex numbers.")]
    [TestCase("v 0 0\nl x\n", "1:6: error curves.obj: A vertex needs three numbers.")]
    [TestCase("v 0 0 0\nv 1e999 0 0\nl 1 2\nl x\n", "3:5: error curves.not_finite: A line uses a vertex that is not finite.")]
    public void The_first_error_of_an_obj_ends_it(string text, string error)
        => Assert.That(CurveReaderTests.Read(text, "a.obj").Diagnostics.Select(d => d.ToString()), Is.EqualTo(new[] { "a.obj:" + error }));

    [Test]
    public void Vertices_are_counted_from_both_ends_and_may_have_textures()
    {
        var curve = CurveReaderTests.Read("o part # 1\nv 0 0 0\nv 3 0 0\nv 3 4 0\nl 1/1 2/7 -1 # end\n", "a.obj.gz").Value!.Single();
        Assert.That(curve.Curve.Length, Is.EqualTo(7));
    }

    [TestCase("a.csv.gz", true)]
    [TestCase("a.txt", true)]
    [TestCase("a.data", false)]
    [TestCase("a.json.gz", false)]
    public void A_name_says_what_a_file_is_else_its_text(string name, bool fails)
        => Assert.That(CurveReaderTests.Read("[[0,0],[1,0]]", name).HasErrors, Is.EqualTo(fails));

    [Test]
    public void Lengths_of_all_files_are_in_the_unit_that_is_asked_for()
    {
        var inches = new CurveReadOptions { UnitLength = 25.4 };
        foreach (var (text, name) in new[] { ("v 0 0 0\nv 1 0 0\nl 1 2\n", "a.obj"), ("\n0,0,0\n1,0,0\n", "a.csv"), ("[[0,0],[1,0]]", "a.json") })
            Assert.That(CurveReaderTests.Read(text, name, inches).Value!.Single().Curve.Length, Is.EqualTo(25.4).Within(1e-12), name);
    }

    [Test]
    public void Errors_of_curves_are_sentences_without_names_of_parameters()
    {
        var wrong = Read("{\"degree\":2,\"points\":[[0,0],[1,0],[1,1]],\"knots\":[0,0,0,1]}").Diagnostics.Single();
        Assert.That(wrong.Message, Does.EndWith(".").And.Not.Contain("arameter"));
    }

    [Test]
    public void A_role_alone_reaches_the_path()
    {
        var curve = new UserCurve(new PolylineCurve([Vec3.Zero, Vec3.UnitX], false));
        Assert.That(CurvePaths.ToPaths([curve with { Role = Role.Brim }]).Value!.Single().Role, Is.EqualTo(Role.Brim));
        Assert.That(CurvePaths.ToPaths([curve with { Tool = 2 }]).Value!.Single().Tool, Is.EqualTo(2));
        Assert.That(CurvePaths.ToPaths([curve with { Name = "n" }]).Value!.Single().Name, Is.EqualTo("n"));
    }

    [Test]
    public void Paths_of_curves_without_a_name_have_no_key_in_their_place()
    {
        var line = new PolylineCurve([Vec3.Zero, new Vec3(5, 0, -1)], false);
        UserCurve[] curves = [new(line), new(line) { Name = "leaf" }, new(line) { Name = "leaf", Source = new SourceLocation("f", Key: "k") }];
        Assert.That(curves.Select(c => CurvePaths.ToSteps([c]).Value!.Single().Source?.Key), Is.EqualTo(new[] { null, "leaf", "k" }));
    }

    private static Result<System.Collections.Generic.IReadOnlyList<UserCurve>> Read(string text) => CurveReaderTests.Read(text, "a.json");
}
