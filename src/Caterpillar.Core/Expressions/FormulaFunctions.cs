namespace Caterpillar.Expressions;

/// <summary>The functions of formulas. Angles are degrees.</summary>
internal static class FormulaFunctions
{
    public static readonly IReadOnlyList<string> Names =
    [
        "sin", "cos", "tan", "asin", "acos", "atan", "atan2", "sqrt", "abs", "min", "max", "floor", "ceil", "round", "trunc", "frac", "sign", "exp", "ln",
            "log", "pow", "mod", "hypot",
        "clamp", "lerp", "step", "smoothstep", "deg", "rad", "random", "randint", "noise",
    ];

    public static bool Knows(string name) => Names.Contains(name);

    public static FormulaNode Call(Token name, List<FormulaNode> a)
    {
        var node = name.Text == "noise" ? Smooth(a) : a.Count switch
        {
            0 => name.Text == "random" ? new FormulaNode(c => c.Random.NextDouble()) : null,
            1 => One(name.Text, a[0]),
            2 => Two(name.Text, a[0], a[1]),
            3 => Three(name.Text, a[0], a[1], a[2]),
            _ => null,
        };
        if (node is null && name.Text is "min" or "max" && a.Count > 2)
        {
            node = a[0];
            for (var i = 1; i < a.Count; i++) node = Two(name.Text, node!, a[i]);
        }
        return node ?? throw new FormulaException("formula.arguments",
            $"The function '{name.Text}' takes {Count(name.Text)}, not {NumberFormatter.Format(a.Count)}.", name);
    }

    private static FormulaNode? One(string name, FormulaNode a) => name switch
    {
        "sin" => FormulaNode.Of(a, Angle.Sin),
        "cos" => FormulaNode.Of(a, Angle.Cos),
        "tan" => FormulaNode.Of(a, Tan),
        "asin" => FormulaNode.Of(a, x => Angle.Atan2(x, Math.Sqrt((1 - x) * (1 + x)))),
        "acos" => FormulaNode.Of(a, x => Angle.Atan2(Math.Sqrt((1 - x) * (1 + x)), x)),
        "atan" => FormulaNode.Of(a, x => Angle.Atan2(x, 1)),
        "sqrt" => FormulaNode.Of(a, Math.Sqrt),
        "abs" => FormulaNode.Of(a, Math.Abs),
        "min" or "max" => a,
        "floor" => FormulaNode.Of(a, Math.Floor),
        "ceil" => FormulaNode.Of(a, Math.Ceiling),
        "round" => FormulaNode.Of(a, Round),
        "trunc" => FormulaNode.Of(a, Math.Truncate),
        "frac" => FormulaNode.Of(a, x => x - Math.Floor(x)),
        "sign" => FormulaNode.Of(a, x => x > 0 ? 1 : x < 0 ? -1 : x == 0 ? 0 : double.NaN),
        "exp" => FormulaNode.Of(a, Math.Exp),
        "ln" => FormulaNode.Of(a, Math.Log),
        "log" => FormulaNode.Of(a, Math.Log10),
        "deg" => FormulaNode.Of(a, Angle.ToDegrees),
        "rad" => FormulaNode.Of(a, Angle.ToRadians),
        "random" => FormulaNode.Of(a, SeededRandom.Of),
        _ => null,
    };

    private static FormulaNode? Two(string name, FormulaNode a, FormulaNode b)
    {
        switch (name)
        {
            case "atan2": return FormulaNode.Of(a, b, Angle.Atan2);
            // Written out: the runtimes differ for NaN and for zeros of either sign.
            case "min": return FormulaNode.Of(a, b, (x, y) => double.IsNaN(x) || x < y ? x : y);
            case "max": return FormulaNode.Of(a, b, (x, y) => double.IsNaN(x) || x > y ? x : y);
            case "log": return FormulaNode.Of(a, b, (x, y) => Math.Log(x) / Math.Log(y));
            case "pow": return FormulaNode.Of(a, b, Math.Pow);
            case "mod": return FormulaNode.Of(a, b, (x, y) => x - y * Math.Floor(x / y));
            case "hypot": return FormulaNode.Of(a, b, (x, y) => Math.Sqrt(x * x + y * y));
            case "step": return FormulaNode.Of(a, b, (edge, x) => x < edge ? 0 : 1);
            case "random" or "randint":
                var low = a.Evaluate;
                var high = b.Evaluate;
                var depth = Math.Max(a.Depth, b.Depth) + 1;
                return name == "random"
                    ? new FormulaNode(c => Between(low(c), high(c), c.Random.NextDouble()), depth)
                    : new FormulaNode(c => Integer(Math.Ceiling(low(c)), Math.Floor(high(c)), c.Random.NextDouble()), depth);
            default: return null;
        }
    }

    private static FormulaNode? Three(string name, FormulaNode a, FormulaNode b, FormulaNode t)
    {
        Func<double, double, double, double>? f = name switch
        {
            "clamp" => (x, low, high) => x < low ? low : x > high ? high : x,
            "lerp" => Between,
            "smoothstep" => (from, to, x) =>
            {
                var u = (x - from) / (to - from);
                u = u < 0 ? 0 : u > 1 ? 1 : u;
                return u * u * (3 - 2 * u);
            },
            _ => null,
        };
        if (f is null) return null;
        var (p, q, r) = (a.Evaluate, b.Evaluate, t.Evaluate);
        if (a.IsConstant && b.IsConstant && t.IsConstant) return new FormulaNode(f(a.Value, b.Value, t.Value));
        return new FormulaNode(c => f(p(c), q(c), r(c)), Math.Max(a.Depth, Math.Max(b.Depth, t.Depth)) + 1);
    }

    // It depends on the seed, so that constants are not folded.
    private static FormulaNode? Smooth(List<FormulaNode> a)
    {
        if (a.Count is 0 or > 3) return null;
        var x = a[0].Evaluate;
        var y = a.Count > 1 ? a[1].Evaluate : _ => 0;
        var z = a.Count > 2 ? a[2].Evaluate : _ => 0;
        return new FormulaNode(c => Noise.At(c.Random.Seed, x(c), y(c), z(c)), a.Max(node => node.Depth) + 1);
    }

    private static double Tan(double degrees)
    {
        var (sin, cos) = Angle.SinCos(degrees);
        return sin / cos;
    }

    private static double Between(double from, double to, double t) => t == 1 ? to : from + (to - from) * t;

    private static double Integer(double low, double high, double u) => low > high ? double.NaN : low + Math.Min(Math.Floor(u * (high - low + 1)), high - low);

    // Halves are rounded away from zero, as in formatted numbers.
    private static double Round(double x)
    {
        var size = Math.Abs(x);
        var whole = Math.Floor(size);
        if (size - whole >= 0.5) whole++;
        return x < 0 ? -whole : whole;
    }

    private static string Count(string name) => name switch
    {
        "random" => "no value (the next number), one (a seed) or two (from, to)",
        "min" or "max" => "at least one value",
        "noise" => "one to three values (x, y, z)",
        "log" => "one or two values (value, base)",
        "atan2" or "pow" or "mod" or "hypot" or "step" or "randint" => "two values",
        "clamp" or "lerp" or "smoothstep" => "three values",
        _ => "one value",
    };
}
