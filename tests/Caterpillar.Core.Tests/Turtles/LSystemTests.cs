using System;
using System.Collections.Generic;
using System.Linq;
using Caterpillar.Basics;
using Caterpillar.Geometry;
using Caterpillar.Toolpaths;
using Caterpillar.Turtles;
using NUnit.Framework;

namespace Caterpillar.Tests.Turtles;

internal sealed class LSystemTests
{
    private static LSystem System(string axiom, params string[] rules)
    {
        var result = LSystem.Parse(axiom, rules);
        Assert.That(result.Diagnostics, Is.Empty);
        return result.Value!;
    }

    private static string Word(int generations, string axiom, params string[] rules) => System(axiom, rules).Grow(generations).Value!.ToString();

    [Test]
    public void Algae_grow_as_in_the_book()
    {
        string[] rules = ["A -> AB", "B -> A"];
        Assert.That(Word(0, "A", rules), Is.EqualTo("A"));
        Assert.That(Word(5, "A", rules), Is.EqualTo("ABAABABAABAAB"));
        // Lengths are Fibonacci numbers.
        Assert.That(Enumerable.Range(0, 12).Select(g => System("A", rules).Grow(g).Value!.Count),
            Is.EqualTo(new[] { 1, 2, 3, 5, 8, 13, 21, 34, 55, 89, 144, 233 }));
    }

    [Test]
    public void Growing_agrees_with_replacing_text()
    {
        var random = new Random(4);
        for (var i = 0; i < 50; i++)
        {
            string Random(int n) => new(Enumerable.Range(0, n).Select(_ => "FGX+-[]"[random.Next(7)]).ToArray());
            var (f, x) = (Random(random.Next(4)), Random(random.Next(5)));
            var text = Random(6);
            var grown = Word(4, text, "F -> " + f, "X=" + x);
            for (var g = 0; g < 4; g++) text = string.Concat(text.Select(c => c == 'F' ? f : c == 'X' ? x : c.ToString()));
            Assert.That(grown, Is.EqualTo(text));
        }
    }

    [Test]
    public void Values_are_computed_and_conditions_choose()
    {
        string[] rules = ["A(x, y) : y <= 3 -> A(x * 2, x + y)", "A(x, y) : y > 3 -> B(x) A(x / y, 0)", "B(x) : x < 1 -> C", "B(x) : x >= 1 -> B(x - 1)"];
        // Prusinkiewicz and Lindenmayer 1990, section 1.10.1 (figure 1.38).
        Assert.That(Word(0, "B(2) A(4, 4)", rules), Is.EqualTo("B(2)A(4,4)"));
        Assert.That(Word(1, "B(2) A(4, 4)", rules), Is.EqualTo("B(1)B(4)A(1,0)"));
        Assert.That(Word(2, "B(2) A(4, 4)", rules), Is.EqualTo("B(0)B(3)A(2,1)"));
        Assert.That(Word(3, "B(2) A(4, 4)", rules), Is.EqualTo("CB(2)A(4,3)"));
        Assert.That(Word(4, "B(2) A(4, 4)", rules), Is.EqualTo("CB(1)A(8,7)"));
        Assert.That(Word(1, "A", "A(x) -> B"), Is.EqualTo("A"), "another number of values is another letter");
    }

    [Test]
    public void Of_several_rules_that_fit_the_first_has_its_own_names_of_the_values()
        => Assert.That(Word(1, "F(1, 2)", "F(x, y) -> A(x, y)", "F(y, x) -> B(x, y)"), Is.EqualTo("A(1,2)"));

    [Test]
    public void Weights_share_out_the_choices_and_the_seed_repeats_them()
    {
        var system = System(new string('F', 10_000), "0.2 F -> A", "0.5 F -> B", "0.3 F -> C");
        var word = system.Grow(1, seed: 7).Value!.ToString();
        Assert.That(system.Grow(1, seed: 7).Value!.ToString(), Is.EqualTo(word));
        Assert.That(system.Grow(1, seed: 8).Value!.ToString(), Is.Not.EqualTo(word));
        Assert.That(word.Count(c => c == 'A'), Is.EqualTo(2000).Within(150));
        Assert.That(word.Count(c => c == 'B'), Is.EqualTo(5000).Within(200));
        Assert.That(Word(1, "1", "1 -> 11"), Is.EqualTo("11"), "a digit may be a letter");
    }

    [Test]
    public void A_weight_is_a_probability_and_else_the_letter_stays()
    {
        var word = System(new string('F', 10_000), "0.3 F -> AA").Grow(1, seed: 7).Value!.ToString();
        Assert.That(word.Count(c => c == 'A') / 2, Is.EqualTo(3000).Within(150));
        Assert.That(word.Count(c => c == 'F'), Is.EqualTo(7000).Within(150));
        // A letter that stayed by chance may change in a later generation.
        Assert.That(System("F", "0.3 F -> A").Grow(100, seed: 1).Value!.ToString(), Is.EqualTo("A"));
    }

    [Test]
    public void A_rule_without_a_weight_takes_what_the_weights_leave()
    {
        var word = System(new string('F', 10_000), "0.25 F -> A", "F -> B").Grow(1, seed: 3).Value!.ToString();
        Assert.That(word.Count(c => c == 'A'), Is.EqualTo(2500).Within(150));
        Assert.That(word.Count(c => c == 'B'), Is.EqualTo(10_000 - word.Count(c => c == 'A')));
    }

    [Test]
    public void Weights_of_more_than_1_are_an_error()
    {
        var error = LSystem.Parse("F", ["0.7 F -> A", "0.4 F -> B"]).Diagnostics.Single();
        Assert.That((error.Code, error.Source!.Line), Is.EqualTo(("lsystem.weights", (int?)2)));
        Assert.That(error.Message, Does.Contain("1.1"));
        // Conditions may exclude each other: those show while a word grows.
        string[] rules = ["0.7 F(x) : x > 0 -> A", "0.7 F(x) : x < 2 -> B"];
        Assert.That(System("F(-1)F(3)", rules).Grow(1).Diagnostics, Is.Empty);
        Assert.That(System("F(1)", rules).Grow(1).Diagnostics.Single().Code, Is.EqualTo("lsystem.weights"));
    }

    [Test]
    public void A_letter_whose_rules_have_another_number_of_values_is_noted()
    {
        var note = System("AA(1)A", "A(x) -> B").Grow(1).Diagnostics.Single();
        Assert.That((note.Severity, note.Code, note.Count), Is.EqualTo((Severity.Note, "lsystem.value_count", 2)));
        Assert.That(note.Message, Is.EqualTo("'A' with 0 values stays unchanged. Number of values in its rules: 1."));
        Assert.That(System("AA(1)", "A -> B", "A(x) -> C").Grow(1).Diagnostics, Is.Empty);
    }

    // A signal travels along the word, one letter a generation (Prusinkiewicz and Lindenmayer 1990, section 1.8).
    [TestCase("baaaa", "b < a -> b", 3, "bbbba")]
    [TestCase("aaab", "a > b -> b", 2, "abbb")]
    [TestCase("xaz", "x < a > z -> Q", 1, "xQz")]
    [TestCase("yaz", "x < a > z -> Q", 1, "yaz")]
    [TestCase("x+[c]-az", "x < a > z -> Q", 1, "x+[c]-Qz")]
    [TestCase("x[+a]z", "x < a -> Q", 1, "x[+Q]z")]
    [TestCase("x[+a]z", "a > z -> Q", 1, "x[+a]z")]
    [TestCase("xya", "xy < a -> Q", 1, "xyQ")]
    [TestCase("a[b]cd", "a > cd -> Q", 1, "Q[b]cd")]
    [TestCase("a[b]cd", "a > c d -> Q", 1, "Q[b]cd")]
    [TestCase("F+F", "F > + -> Q", 1, "Q+F")]
    public void Contexts_follow_the_branch(string axiom, string rule, int generations, string word)
        => Assert.That(Word(generations, axiom, rule), Is.EqualTo(word));

    [Test]
    public void Contexts_see_their_values()
        => Assert.That(Word(1, "A(1)B(2)C(5)", "A(x) < B(y) > C(z) : z > 4 -> B(x + 10 * y + 100 * z)"), Is.EqualTo("A(1)B(521)C(5)"));

    [TestCase("a < -> b")]
    [TestCase("a > -> b")]
    [TestCase("a[ < b -> c")]
    [TestCase("a < b c -> d")]
    public void Contexts_that_are_none_are_errors(string rule)
        => Assert.That(LSystem.Parse("a", [rule]).Diagnostics.Single().Code, Is.EqualTo("lsystem.rule"));

    [Test]
    public void Rules_in_a_script_see_its_variables()
    {
        // F(2 * 3), F(6 * 3) …; the value of the rule hides the variable of its name.
        var turtle = TurtleScript.Compile("k = 3\nx = 100\ndef F d [ forward d ]\nlsystem 2 \"F(2)\" \"F(x) -> F(x * k)\"").Value!.Run().Value!;
        Assert.That(turtle.X, Is.EqualTo(18).Within(1e-12));
        var local = TurtleScript.Compile("def grow size [ lsystem 1 \"A\" \"A -> F(size)\" ]\nk = 4\ngrow 7").Value!.Run().Value!;
        Assert.That(local.X, Is.EqualTo(7).Within(1e-12));
        var unset = TurtleScript.Compile("lsystem 1 \"A\" \"A -> F(late)\"\nlate = 2").Value!.Run();
        Assert.That(unset.Diagnostics.Single().Code, Is.EqualTo("turtle.no_value"));
        var note = TurtleScript.Compile("\nlsystem 1 \"F\" \"F(x) -> F\"").Value!.Run().Diagnostics.Single();
        Assert.That((note.Code, note.Source!.Line), Is.EqualTo(("lsystem.value_count", (int?)2)));
    }

    [Test]
    public void Growth_beyond_the_limit_is_an_error()
    {
        var result = System("F", "F -> FF").Grow(40, maxSymbols: 1000);
        Assert.That(result.Value, Is.Null);
        Assert.That(result.Diagnostics.Single().Code, Is.EqualTo("lsystem.too_large"));
        Assert.That(result.Diagnostics.Single().Message, Does.Contain("Generation 10"));

    }

    [TestCase("F", "F + F", 1, 1, "lsystem.rule")]
    [TestCase("F", "-> F", 1, 1, "lsystem.rule")]
    [TestCase("F", "FG -> F", 1, 2, "lsystem.rule")]
    [TestCase("F", "F(x -> F", 1, 2, "lsystem.bracket")]
    [TestCase("F", "F(x) -> F(x +)", 1, 14, "formula.syntax")]
    [TestCase("F", "F(x) : y > 1 -> F", 1, 8, "formula.unknown")]
    [TestCase("F(", "F -> F", 0, 2, "lsystem.bracket")]
    [TestCase("F)", "F -> F", 0, 2, "lsystem.bracket")]
    public void Errors_state_their_position(string axiom, string rule, int line, int column, string code)
    {
        var error = LSystem.Parse(axiom, [rule]).Diagnostics.Single();
        Assert.That((error.Source!.Line, error.Source.Column, error.Code), Is.EqualTo(((int?)line, (int?)column, code)), error.Message);
        Assert.That(error.Source.Key, Is.EqualTo(line == 0 ? "axiom" : "rule 1"));
    }

    [Test]
    public void Values_that_are_not_finite_are_reported()
        => Assert.That(System("A(0)", "A(x) -> A(1 / x)").Grow(2).Diagnostics.Single().Code, Is.EqualTo("lsystem.value"));

    [Test]
    public void Letters_move_the_turtle()
    {
        var turtle = new Turtle();
        Assert.That(Draw("F+F[-F]f", turtle, 10, 90), Is.Empty);
        Assert.That(turtle.Position.DistanceTo(new Vec3(10, 20)), Is.LessThan(1e-12));
        var steps = turtle.ToSteps();
        Assert.That(steps.Select(s => s is TravelStep t ? t.Intent.ToString() : "Path"), Is.EqualTo(new[] { "Path", "Return", "AsDrawn" }));
        var other = new Turtle();
        Draw("F(3)+(45)F(2)|F(2)", other, 10, 90);
        Assert.That(other.Position.DistanceTo(new Vec3(3, 0)), Is.LessThan(1e-12));
        var unpushed = Draw("F]", new Turtle(), 1, 90).Single();
        Assert.That((unpushed.Code, unpushed.Source!.Column), Is.EqualTo(("lsystem.bracket", (int?)2)));
        Assert.That(unpushed.Message, Does.StartWith("Letter 2 (']')"));
        Assert.That(Draw("[F", new Turtle(), 1, 90).Single().Message, Does.Contain("without a closing"));
    }

    [Test]
    public void Brackets_return_to_their_branch()
    {
        // A ternary tree of n levels has (3^n - 1) / 2 branches and ends where its trunk does.
        var turtle = new Turtle();
        Draw(Word(6, "A", "A -> F[+A][-A][A]"), turtle, 1, 25);
        Assert.That(TurtleHistory.Of(turtle.ToSteps()).Count(m => m.Prints), Is.EqualTo((int)(Math.Pow(3, 6) - 1) / 2));
        Assert.That(turtle.Position, Is.EqualTo(new Vec3(1, 0)));
    }

    private static global::System.Collections.Generic.IReadOnlyList<Diagnostic> Draw(string word, Turtle turtle, double step, double angle)
        => System(word).Grow(0).Value!.Draw(turtle, step, angle);
}
