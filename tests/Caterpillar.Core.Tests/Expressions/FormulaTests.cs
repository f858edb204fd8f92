using System;
using System.Linq;
using Caterpillar.Basics;
using Caterpillar.Expressions;
using NUnit.Framework;

namespace Caterpillar.Tests.Expressions;

internal sealed class FormulaTests
{
    private static double Value(string text, params (string Name, double Value)[] variables)
    {
        var result = Formula.Compile(text, variables.Select(v => v.Name).ToArray());
        Assert.That(result.Diagnostics, Is.Empty, text);
        return result.Value!.Evaluate(variables.Select(v => v.Value).ToArray());
    }

    private static Diagnostic Error(string text, params string[] variables)
    {
        var result = Formula.Compile(text, variables);
        Assert.That(result.Value, Is.Null, text);
        return result.Diagnostics.Single();
    }

    [TestCase("1 + 2 * 3", 7)]
    [TestCase("(1 + 2) * 3", 9)]
    [TestCase("10 - 4 - 3", 3)]
    [TestCase("2 ^ 3 ^ 2", 512)]
    [TestCase("-2 ^ 2", -4)]
    [TestCase("2 ^ -1", 0.5)]
    [TestCase("7 % 4", 3)]
    [TestCase("-7 % 4", -3)]
    [TestCase("mod(-7, 4)", 1)]
    [TestCase("- - 3", 3)]
    [TestCase("1e3 + .5", 1000.5)]
    [TestCase("1 < 2 and 2 >= 2", 1)]
    [TestCase("not 1 == 2", 1)]
    [TestCase("1 > 2 or 3 != 3", 0)]
    [TestCase("1 > 2 ? 10 : 2 > 1 ? 20 : 30", 20)]
    [TestCase("5 \u2212 2 \u00D7 2", 1)]
    public void Operators_have_their_usual_precedence(string text, double expected) => Assert.That(Value(text), Is.EqualTo(expected));

    [TestCase("sin(30)", 0.5)]
    [TestCase("cos(60)", 0.5)]
    [TestCase("sin(720 + 90)", 1)]
    [TestCase("tan(45)", 1)]
    [TestCase("asin(1)", 90)]
    [TestCase("acos(-1)", 180)]
    [TestCase("atan2(1, -1)", 135)]
    [TestCase("sqrt(2) ^ 2 - 2", 4.440892098500626e-16)]
    [TestCase("min(3, 1, 2)", 1)]
    [TestCase("max(3, 1, 2)", 3)]
    [TestCase("min(sqrt(-1), 1)", double.NaN)]
    [TestCase("max(sqrt(-1), 1)", double.NaN)]
    [TestCase("round(2.5)", 3)]
    [TestCase("round(-2.5)", -3)]
    [TestCase("round(0.49999999999999994)", 0)]
    [TestCase("sign(-3)", -1)]
    [TestCase("sign(-0.1)", -1)]
    [TestCase("sign(0)", 0)]
    [TestCase("sign(0.1)", 1)]
    [TestCase("frac(-0.25)", 0.75)]
    [TestCase("clamp(5, 0, 3)", 3)]
    [TestCase("lerp(10, 20, 0.25)", 12.5)]
    [TestCase("log(1000)", 3)]
    [TestCase("log(8, 2)", 3)]
    [TestCase("hypot(3, 4)", 5)]
    [TestCase("smoothstep(0, 2, 1)", 0.5)]
    [TestCase("smoothstep(2, 4, 2.5)", 0.15625)]
    [TestCase("smoothstep(0, 2, 3)", 1)]
    [TestCase("smoothstep(0, 2, -3)", 0)]
    [TestCase("deg(pi)", 180)]
    public void Functions_have_their_values(string text, double expected) => Assert.That(Value(text), Is.EqualTo(expected).Within(1e-15));

    [Test]
    public void Variables_are_read_by_slot()
    {
        Assert.That(Value("x * 10 + y", ("x", 3), ("y", 4)), Is.EqualTo(34));
        var formula = Formula.Compile("2 * t", ["t"]).Value!;
        var context = new FormulaContext([1.5]);
        Assert.That(formula.Evaluate(context), Is.EqualTo(3));
        context.Values[0] = 5;
        Assert.That(formula.Evaluate(context), Is.EqualTo(10));
    }

    [Test]
    public void Every_function_agrees_with_the_framework()
    {
        var random = new Random(5);
        for (var i = 0; i < 300; i++)
        {
            var x = random.NextDouble() * 20 - 10;
            var y = random.NextDouble() * 9 + 0.5;
            var vars = new[] { ("x", x), ("y", y) };
            Assert.That(Value("sin(x) + cos(x) + tan(x)", vars),
                Is.EqualTo(Math.Sin(x * Math.PI / 180) + Math.Cos(x * Math.PI / 180) + Math.Tan(x * Math.PI / 180)).Within(1e-12));
            Assert.That(Value("exp(x) + ln(y) + log(y)", vars), Is.EqualTo(Math.Exp(x) + Math.Log(y) + Math.Log10(y)).Within(1e-9));
            Assert.That(Value("atan(x) + asin(x / 10) + acos(x / 10)", vars), Is.EqualTo(Math.Atan(x) * 180 / Math.PI + 90).Within(1e-10));
            Assert.That(Value("y ^ x + pow(y, 2) + abs(x) + floor(x) + ceil(x) + trunc(x)", vars),
                Is.EqualTo(Math.Pow(y, x) + Math.Pow(y, 2) + Math.Abs(x) + Math.Floor(x) + Math.Ceiling(x) + Math.Truncate(x))
                    .Within(1e-6 * Math.Pow(y, Math.Abs(x))));
        }
    }

    [Test]
    public void Division_by_zero_and_roots_of_negatives_are_values_for_the_caller_to_report()
    {
        Assert.That(Value("1 / x", ("x", 0)), Is.EqualTo(double.PositiveInfinity));
        Assert.That(Value("sqrt(x)", ("x", -1)), Is.NaN);
        Assert.That(Value("0 / x", ("x", 0)), Is.NaN);
    }

    [Test]
    public void Random_integers_reach_both_limits_equally_often()
    {
        var random = new SeededRandom(7);
        var counts = new int[3];
        for (var i = 0; i < 3000; i++) counts[random.NextInteger(-1, 1) + 1]++;
        // 1000 ± 26 are expected; five times that never occurs by chance.
        Assert.That(counts, Has.All.InRange(870, 1130));
    }

    [Test]
    public void Random_numbers_come_from_the_seed_alone()
    {
        var formula = Formula.Compile("random()").Value!;
        Assert.That(formula.UsesRandom, Is.True);
        double[] Draw(int seed)
        {
            var context = new FormulaContext([], new SeededRandom(seed));
            return Enumerable.Range(0, 1000).Select(_ => formula.Evaluate(context)).ToArray();
        }
        Assert.That(Draw(7), Is.EqualTo(Draw(7)));
        Assert.That(Draw(7), Is.Not.EqualTo(Draw(8)));
        Assert.That(Draw(7), Has.All.InRange(0, 1));
        Assert.That(Draw(7).Average(), Is.EqualTo(0.5).Within(0.05));
        Assert.That(new SeededRandom(42).NextDouble(), Is.EqualTo(0.08299378146589231).Within(0), "the numbers never change");
        Assert.That(Value("random(3)"), Is.EqualTo(Value("random(3)")).And.Not.EqualTo(Value("random(4)")));
        Assert.That(Formula.Compile("random(x)", ["x"]).Value!.UsesRandom, Is.False);
        var cup = new FormulaContext([], new SeededRandom(1));
        double[] Thrown(string dice)
        {
            var die = Formula.Compile(dice).Value!;
            return [.. Enumerable.Range(0, 600).Select(_ => die.Evaluate(cup)).Distinct().OrderBy(d => d)];
        }
        Assert.That(Thrown("randint(1, 6)"), Is.EqualTo(new double[] { 1, 2, 3, 4, 5, 6 }));
        Assert.That(Thrown("randint(-3, -1)"), Is.EqualTo(new double[] { -3, -2, -1 }));
    }

    [TestCase("1 +", 1, 4, "formula.syntax")]
    [TestCase("sine(3)", 1, 1, "formula.unknown")]
    [TestCase("2 * (3 + 4", 1, 5, "formula.bracket")]
    [TestCase("x = 3", 1, 3, "formula.syntax")]
    [TestCase("1 < x < 3", 1, 7, "formula.syntax")]
    [TestCase("clamp(1, 2)", 1, 1, "formula.arguments")]
    [TestCase("sin 30", 1, 1, "formula.syntax")]
    [TestCase("3 $ 4", 1, 3, "formula.character")]
    [TestCase("1 2", 1, 3, "formula.syntax")]
    [TestCase("", 1, 1, "formula.syntax")]
    [TestCase("3x", 1, 1, "formula.number")]
    [TestCase("\n  1 +\n  * 2", 3, 3, "formula.syntax")]
    public void Errors_state_their_position(string text, int line, int column, string code)
    {
        var error = Error(text, "x");
        Assert.That((error.Source!.Line, error.Source.Column, error.Code), Is.EqualTo((line, column, code)), error.Message);
    }

    [Test]
    public void Unknown_names_come_with_a_suggestion()
    {
        Assert.That(Error("radus * 2", "radius", "height").Message, Does.Contain("Did you mean 'radius'?"));
        Assert.That(Error("squrt(2)").Message, Does.Contain("Did you mean 'sqrt'?"));
        Assert.That(Error("qqqqqq").Message, Does.Not.Contain("Did you mean"));
    }

    [Test]
    public void Formulas_too_deep_or_too_long_are_refused()
    {
        Assert.That(Error(new string('(', 100_000)).Code, Is.EqualTo("formula.too_long"));
        Assert.That(Error("x" + string.Concat(Enumerable.Repeat("+x", 100_000)), "x").Code, Is.EqualTo("formula.too_long"));
        Assert.That(Error(string.Concat(Enumerable.Repeat("2^", 100_000)) + "2").Code, Is.EqualTo("formula.too_long"));
        Assert.That(Value(string.Concat(Enumerable.Repeat("-", 100_000)) + "2"), Is.EqualTo(2));
    }

    [Test]
    public void No_text_makes_it_throw()
    {
        var random = new Random(11);
        const string Alphabet = "0123456789.+-*/%^()[]<>=!?:&|,;\"#x y\nsincosandornotpi\u2212\u00e4{";
        for (var i = 0; i < 3000; i++)
        {
            var text = new string(Enumerable.Range(0, random.Next(1, 25)).Select(_ => Alphabet[random.Next(Alphabet.Length)]).ToArray());
            var result = Formula.Compile(text, ["x", "y"]);
            Assert.That(result.Value is null, Is.EqualTo(result.HasErrors), text);
            result.Value?.Evaluate(1, 2);
        }
    }

    [TestCase("not 0", 1)]
    [TestCase("not 1", 0)]
    [TestCase("not 0.5", 0)]
    [TestCase("not not 3", 1)]
    [TestCase("not not 0", 0)]
    [TestCase("1 != 2", 1)]
    [TestCase("2 != 2", 0)]
    [TestCase("1 <> 2", 1)]
    [TestCase("(1 < 2) + (2 > 1) + (1 <= 1) + (1 >= 1) + (1 == 1)", 5)]
    [TestCase("(2 and 3) + (0 or 5)", 2)]
    public void Comparisons_and_logic_are_1_or_0(string text, double value)
    {
        Assert.That(Value(text), Is.EqualTo(value));
        Assert.That(Value(text.Replace("2", "a"), ("a", 2)), Is.EqualTo(value), "with a variable");
    }

    [TestCase("step(1, 0.9)", 0)]
    [TestCase("step(1, 1)", 1)]
    [TestCase("step(1, 1.1)", 1)]
    public void A_step_is_1_from_its_edge_on(string text, double value) => Assert.That(Value(text), Is.EqualTo(value));

    [Test]
    public void A_formula_without_variables_is_constant()
    {
        Assert.That(Formula.Compile("2 * (3 + sin(30))", []).Value!.IsConstant, Is.True);
        Assert.That(Formula.Compile("2 * x", ["x"]).Value!.IsConstant, Is.False);
    }

    [TestCase("(1 + 2", "'(' has no closing ')'.")]
    [TestCase("(1 + 2 [3]", "'(' has no closing ')'.")]
    [TestCase("(1 + 2; 3", "'(' has no closing ')'.")]
    public void A_bracket_that_is_not_closed_is_named_where_it_opens(string text, string message)
    {
        var error = Error(text);
        Assert.That((error.Message, error.Source!.Column), Is.EqualTo((message, 1)));
    }
}
