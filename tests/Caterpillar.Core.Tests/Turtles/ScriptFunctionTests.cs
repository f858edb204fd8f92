using System;
using System.IO;
using System.Linq;
using System.Text;
using Caterpillar.Basics;
using Caterpillar.Files;
using Caterpillar.Geometry;
using Caterpillar.Turtles;
using NUnit.Framework;

namespace Caterpillar.Tests.Turtles;

/// <summary>Functions that return values, printed lines, noise, included files and images.</summary>
internal sealed class ScriptFunctionTests
{
    private string _folder = "";

    [SetUp]
    public void MakeFolder()
    {
        _folder = Path.Combine(Path.GetTempPath(), "caterpillar-" + Guid.NewGuid().ToString("N"));
        Directory.CreateDirectory(Path.Combine(_folder, "design", "lib"));
    }

    [TearDown]
    public void RemoveFolder() => Directory.Delete(_folder, true);

    private static double X(string text) => Ran(text).OrThrow().X;

    private static Result<Turtle> Ran(string text, TurtleLimits? limits = null)
    {
        var script = TurtleScript.Compile(text, "p.turtle");
        return script.Value is null ? new Result<Turtle>(null, script.Diagnostics) : script.Value.Run(limits: limits);
    }

    private static Diagnostic Error(string text) => Ran(text).Diagnostics.Single(d => d.Severity == Severity.Error);

    [TestCase("def double x [ return 2 * x ]\nforward double(3)", 6)]
    [TestCase("def twice x [ return 2 * x ]\nforward twice(twice(3)) + 1", 13)]
    [TestCase("def fact n [ return n <= 1 ? 1 : n * fact(n - 1) ]\nforward fact(5)", 120)]
    [TestCase("def fib n [\n if n < 2 [ return n ]\n return fib(n - 1) + fib(n - 2)\n]\nforward fib(15)", 610)]
    [TestCase("def size w h [ return w * h ]\nx = size(2, 3) * size(1, 4)\nforward x", 24)]
    [TestCase("def one [ return 1 ]\nforward one()\nforward one() + one()", 3)]
    [TestCase("def f x [ forward x; return x ]\nforward f(3)", 6, TestName = "A function may draw")]
    [TestCase("def f x [ return x ]\nf 3\nforward 1", 1, TestName = "Its value may be ignored")]
    [TestCase("def total n [ let sum = 0; for i = 1 to n [ sum += i ]; return sum ]\nforward total(100)", 5050)]
    [TestCase("def even n [ return n == 0 or odd(n - 1) ]\ndef odd n [ return n != 0 and even(n - 1) ]\nforward even(200) + 2 * odd(200)", 1)]
    [TestCase("def f x [ if x > 2 [ forward 10; stop ]\n return x ]\nforward f(1)\nforward f(5)\nforward 100", 11, TestName = "stop ends the program")]
    [TestCase("def min2 a b [ return a < b ? a : b ]\nforward min2(4, 3)\nforward min2(\n", -1, TestName = "An open call is an error")]
    public void Procedures_return_values_that_formulas_use(string text, double x)
    {
        if (x < 0) Assert.That(Ran(text).HasErrors);
        else Assert.That(X(text), Is.EqualTo(x).Within(1e-12));
    }

    [TestCase("def f x [ forward x ]\nforward f(1)", 2, 9, "turtle.no_result", "returns no value")]
    [TestCase("def f x [ if x > 1 [ return 1 ] ]\nforward f(0)", 2, 9, "turtle.no_result", "'f' ended without")]
    [TestCase("def f a b [ return a ]\nforward f(1)", 2, 9, "formula.arguments", "takes 2 values, not 1")]
    [TestCase("def f a [ return a / 0 ]\nforward f(1)", 1, 18, "turtle.not_finite", "infinite")]
    [TestCase("def f x [ return x ]\nforward 1\nforward f(1) / 0", 3, 9, "turtle.not_finite", "infinite")]
    [TestCase("def f x [ return x ]\nleft 10 * f(1); forward sqrt(0 - f(4))", 2, 25, "turtle.not_finite", "not a number")]
    [TestCase("def f x [\n return x\n]\nif f(1) [\n  arc f(2) f(0) / f(0)\n]", 5, 12, "turtle.not_finite", "not a number")]
    [TestCase("def f x [ return x ]\narray a 3\na[f(3)] = 1", 3, 1, "turtle.index", "0 to 2")]
    [TestCase("def f x [ return x ]\nseed f(0.5)", 2, 6, "turtle.value", "Found 0.5, expected an integer from -1000000000 to 1000000000.")]
    [TestCase("def f x [ return x ]\nfor i = f(1) to 3 step f(0) [ forward 1 ]", 2, 24, "turtle.value", "must not be 0")]
    [TestCase("def f x [ return x ]\nforward f(1)\nhotend f(0 - 400)", 3, 1, "turtle.value", "'hotend'")]
    [TestCase("def f x [ return x ]\nforward f(f(1 / 0))", 2, 11, "turtle.not_finite", "A value for 'f' is not finite.")]
    [TestCase("return 5", 1, 1, "turtle.syntax", "only allowed in a procedure")]
    [TestCase("def f n [ return f(n + 1) ]\nforward f(0)", 1, 18, "turtle.recursion", "1000 levels")]
    [TestCase("def side [ return 1 ]\nforward sid()", 2, 9, "formula.unknown", "Did you mean 'side'?")]
    [TestCase("forward noise()", 1, 9, "formula.arguments", "one to three values")]
    [TestCase("forward noise(2e9)", 1, 9, "turtle.not_finite", "not a number")]
    [TestCase("include \"other.turtle\"", 1, 9, "turtle.file", "no folder")]
    [TestCase("print 3 [", 1, 9, "turtle.values", "expected a text")]
    [TestCase("print nothing", 1, 7, "formula.unknown", "Unknown variable 'nothing'")]
    public void Errors_of_functions_state_what_and_where(string text, int line, int column, string code, string message)
    {
        var error = Error(text);
        Assert.That((error.Source!.File, error.Source.Line, error.Source.Column, error.Code), Is.EqualTo(("p.turtle", (int?)line, (int?)column, code)),
            error.Message);
        Assert.That(error.Message, Does.Contain(message));
    }

    [Test]
    public void Functions_a_thousand_levels_deep_run_on_any_thread()
    {
        var depth = 0.0;
        var thread = new System.Threading.Thread(() => depth = X("def f n [ return n == 0 ? 0 : 1 + f(n - 1) ]\nforward f(990)"), 256 * 1024);
        thread.Start();
        thread.Join();
        Assert.That(depth, Is.EqualTo(990));
    }

    [Test]
    public void Printed_lines_come_first_in_their_order_even_before_an_error()
    {
        var run = Ran("let n = 2\nprint \"n is {n}, twice {2 * n}\"\nprint n n + 1 \"end\"\nprint\nforward 1 / 0");
        Assert.That(run.Diagnostics.Where(d => d.Code == TurtleScript.PrintCode).Select(d => d.Message),
            Is.EqualTo(new[] { "n is 2, twice 4", "2 3 end", "" }));
        Assert.That(run.Diagnostics[1].Source, Is.EqualTo(new SourceLocation("p.turtle", 3, 1)));
        Assert.That(run.Diagnostics[3].Code, Is.EqualTo("turtle.not_finite"));
        var many = Ran("repeat 10005 [ print repcount ]").Diagnostics;
        Assert.That(many, Has.Count.EqualTo(10_001));
        Assert.That(many[10_000].Message, Does.StartWith("Lines not shown: 5."));
    }

    [Test]
    public void Noise_is_smooth_random_and_the_same_everywhere()
    {
        string Row(string setup) => string.Join(" ",
            Ran(setup + "\nfor i = 0 to 5 [ print noise(i * 0.37) noise(i * 0.37, 1.5) noise(i * 0.37, -2.25, 7.125) ]")
            .Diagnostics.Select(d => d.Message));
        Golden.Check("turtle/noise.txt", Encoding.UTF8.GetBytes(Row("seed 3") + "\n" + Row("seed 4") + "\n"));
        Assert.That(Row("seed 3"), Is.EqualTo(Row("seed 3")).And.Not.EqualTo(Row("seed 4")));
        var values = Ran("array a 40000\nfor i = 0 to 39999 [ forward noise(i * 0.137, i * 0.071, i * 0.0131) / 40000 ]").Value!;
        Assert.That(values.X, Is.EqualTo(0.5).Within(0.02), "the mean");
        // Neighbors are near each other; whole numbers are 0.5.
        Assert.That(X("for i = 1 to 2000 [ if abs(noise(i / 100) - noise((i - 1) / 100)) > 0.03 [ forward 1 ] ]"), Is.Zero);
        Assert.That(X("forward noise(3, -4, 5)"), Is.EqualTo(0.5));
        Assert.That(X("for i = 0 to 9999 [ let n = noise(i * 0.77, 3.3, 0.2); if n < 0 or n > 1 [ forward 1 ] ]"), Is.Zero);
    }

    [Test]
    public void An_included_file_brings_its_procedures_and_runs_once()
    {
        Write("design/lib/parts.turtle", "include \"more.turtle\"\ndef square side [ repeat 4 [ forward side; left 90 ] ]\nforward 1\n");
        Write("design/lib/more.turtle", "param width = 5\ndef half x [ return x / 2 ]\n");
        var run = Compile("include \"lib/parts.turtle\"\ninclude \"lib/parts.turtle\"\nforward half(width)\nsquare 10").OrThrow();
        Assert.That(run.Parameters, Is.EqualTo(new[] { "width" }));
        Assert.That(run.Run().OrThrow().X, Is.EqualTo(3.5).Within(1e-12));
    }

    [TestCase("include \"missing.turtle\"", "design/main.turtle", 1, 9, "turtle.file", "File 'missing.turtle' not found.")]
    [TestCase("include \"../secret.turtle\"", "design/main.turtle", 1, 9, "turtle.file", "outside the folders")]
    [TestCase("include \"/etc/hosts\"", "design/main.turtle", 1, 9, "turtle.file", "outside the folders")]
    [TestCase("\ninclude \"lib/circle.turtle\"", "design/lib/circle.turtle", 2, 9, "turtle.include", "'circle.turtle' includes itself.")]
    [TestCase("include \"lib/wrong.turtle\"", "design/lib/wrong.turtle", 3, 9, "formula.unknown", "Unknown variable 'nothing'")]
    [TestCase("include \"lib/late.turtle\"\nlate", "design/lib/late.turtle", 2, 10, "turtle.not_finite", "infinite")]
    [TestCase("include \"lib/late.turtle\"\nforward value()", "design/lib/late.turtle", 4, 27, "turtle.not_finite", "infinite")]
    [TestCase("include \"lib/late.turtle\"\n\nforward one() / 0", "design/main.turtle", 3, 9, "turtle.not_finite", "infinite")]
    [TestCase("include \"lib\"", "design/main.turtle", 1, 9, "turtle.file", "is a folder")]
    [TestCase("include \"\"", "design/main.turtle", 1, 9, "turtle.file", "not found")]
    [TestCase("repeat 2 [ include \"lib/late.turtle\" ]", "design/main.turtle", 1, 12, "turtle.syntax", "inside a block")]
    [TestCase("include", "design/main.turtle", 1, 1, "turtle.values", "needs a file name")]
    [TestCase("image map \"lib/late.turtle\"", "design/main.turtle", 1, 11, "image.unreadable", "not a PNG image")]
    [TestCase("image map \"lib/map.png\"\nforward map(1)", "design/main.turtle", 2, 9, "formula.arguments", "takes 2 values, not 1")]
    [TestCase("image map \"lib/map.png\"\nimage map \"lib/map.png\"", "design/main.turtle", 2, 7, "turtle.name", "declared twice")]
    [TestCase("image map", "design/main.turtle", 1, 1, "turtle.values", "image name \"file\"")]
    [TestCase("image map \"lib/map.png\" smooth 2", "design/main.turtle", 1, 32, "turtle.values", "image name \"file\"")]
    public void Errors_of_files_name_the_file_and_the_line(string text, string file, int line, int column, string code, string message)
    {
        Write("secret.turtle", "forward 1");
        Write("design/lib/circle.turtle", "forward 1\ninclude \"circle.turtle\"");
        Write("design/lib/wrong.turtle", "\n\nforward nothing");
        Write("design/lib/late.turtle", "def late [\n forward 1 / 0 ]\n\ndef value [ let q = 1 + 5 / (1 - 1); return q ]\ndef one [ return 1 ]");
        WriteMap();
        var script = Compile(text);
        var error = (script.Value is null ? script.Diagnostics : script.Value.Run().Diagnostics).Single(d => d.Severity == Severity.Error);
        Assert.That((error.Source!.File, error.Source.Line, error.Code), Is.EqualTo((file, (int?)line, code)), error.ToString());
        if (code != "turtle.not_finite") Assert.That(error.Source.Column, Is.EqualTo(column), error.ToString());
        Assert.That(error.Message, Does.Contain(message));
    }

    [Test]
    public void Another_folder_may_be_allowed()
    {
        Write("secret.turtle", "forward 7");
        var script = TurtleScript.Compile("include \"secret.turtle\"", "x", new ScriptFiles(Path.Combine(_folder, "design"), _folder)).OrThrow();
        Assert.That(script.Run().OrThrow().X, Is.EqualTo(7));
    }

    [Test]
    public void A_link_does_not_lead_out_of_the_folder()
    {
        if (Path.DirectorySeparatorChar != '/') Assert.Ignore("Links need rights on this system.");
        Write("secret.turtle", "forward 7");
        var link = System.Diagnostics.Process.Start(new System.Diagnostics.ProcessStartInfo("ln", $"-s ../secret.turtle {_folder}/design/link.turtle")
            { UseShellExecute = false })!;
        link.WaitForExit();
        Assert.That(Compile("include \"link.turtle\"").Diagnostics.Single().Message, Does.Contain("links out of the folders"));
    }

    [Test]
    public void An_image_is_a_function_of_two_numbers()
    {
        // Rows from the top: black and white, then a fifth and two fifths.
        WriteMap();
        double At(string u, string v, string smooth = "")
            => Compile($"image map \"lib/map.png\" {smooth}\nforward map({u}, {v})").OrThrow().Run().OrThrow().X;
        Assert.That(At("0.1", "0.9"), Is.Zero);
        Assert.That(At("0.6", "0.9"), Is.EqualTo(1));
        Assert.That(At("0.1", "0"), Is.EqualTo(0.2).Within(1e-12));
        Assert.That(At("1.6", "-3"), Is.EqualTo(0.4).Within(1e-12), "repeated in u, clamped in v");
        Assert.That(At("0.5", "0.75", "smooth"), Is.EqualTo(0.5).Within(1e-12));
    }

    [Test]
    public void A_file_that_includes_too_many_others_is_refused()
    {
        for (var i = 0; i < 102; i++) Write($"design/f{i}.turtle", $"include \"f{i + 1}.turtle\"");
        Assert.That(Compile("include \"f0.turtle\"").Diagnostics.Single().Message, Is.EqualTo("A script can include up to 100 files."));
    }

    private Result<TurtleScript> Compile(string text) => TurtleScript.Compile(text, "design/main.turtle", new ScriptFiles(Path.Combine(_folder, "design")));

    private void WriteMap()
    {
        var map = new RasterImage(2, 2, new Rgb(0, 0, 0));
        (map[1, 0], map[0, 1], map[1, 1]) = (new Rgb(255, 255, 255), new Rgb(51, 51, 51), new Rgb(102, 102, 102));
        File.WriteAllBytes(Path.Combine(_folder, "design", "lib", "map.png"), PngWriter.ToBytes(map));
    }

    private void Write(string name, string text) => File.WriteAllText(Path.Combine(_folder, name), text);
}
