namespace Caterpillar.Expressions;

/// <summary>A compiled formula or a part of one.</summary>
internal delegate double Evaluator(FormulaContext context);

/// <summary>A part of a formula while it is compiled.</summary>
internal sealed class FormulaNode(Evaluator evaluate, int depth = 1)
{
    public FormulaNode(double value) : this(_ => value) => (IsConstant, Value) = (true, value);

    public Evaluator Evaluate { get; } = evaluate;

    public bool IsConstant { get; }

    public double Value { get; }

    /// <summary>Nesting depth of the evaluation.</summary>
    public int Depth { get; } = depth;

    public static FormulaNode Of(FormulaNode a, Func<double, double> function)
    {
        if (a.IsConstant) return new FormulaNode(function(a.Value));
        var x = a.Evaluate;
        return new FormulaNode(c => function(x(c)), a.Depth + 1);
    }

    public static FormulaNode Of(FormulaNode a, FormulaNode b, Func<double, double, double> function)
    {
        if (a.IsConstant && b.IsConstant) return new FormulaNode(function(a.Value, b.Value));
        var x = a.Evaluate;
        var y = b.Evaluate;
        return new FormulaNode(c => function(x(c), y(c)), Deeper(a, b));
    }

    public static FormulaNode Binary(string symbol, FormulaNode a, FormulaNode b)
    {
        var x = a.Evaluate;
        var y = b.Evaluate;
        Evaluator evaluate = symbol switch
        {
            "+" => c => x(c) + y(c),
            "-" => c => x(c) - y(c),
            "*" => c => x(c) * y(c),
            "/" => c => x(c) / y(c),
            "%" => c => x(c) % y(c),
            "^" => c => Math.Pow(x(c), y(c)),
            "<" => c => x(c) < y(c) ? 1 : 0,
            ">" => c => x(c) > y(c) ? 1 : 0,
            "<=" => c => x(c) <= y(c) ? 1 : 0,
            ">=" => c => x(c) >= y(c) ? 1 : 0,
            "==" => c => x(c) == y(c) ? 1 : 0,
            "!=" or "<>" => c => x(c) != y(c) ? 1 : 0,
            "and" => c => x(c) != 0 && y(c) != 0 ? 1 : 0,
            "or" => c => x(c) != 0 || y(c) != 0 ? 1 : 0,
            _ => throw new ArgumentOutOfRangeException(nameof(symbol)),
        };
        return a.IsConstant && b.IsConstant ? new FormulaNode(evaluate(new FormulaContext([]))) : new FormulaNode(evaluate, Deeper(a, b));
    }

    public static FormulaNode Choice(FormulaNode condition, FormulaNode yes, FormulaNode no)
    {
        if (condition.IsConstant) return condition.Value != 0 ? yes : no;
        var test = condition.Evaluate;
        var a = yes.Evaluate;
        var b = no.Evaluate;
        return new FormulaNode(c => test(c) != 0 ? a(c) : b(c), Math.Max(condition.Depth, Math.Max(yes.Depth, no.Depth)) + 1);
    }

    private static int Deeper(FormulaNode a, FormulaNode b) => Math.Max(a.Depth, b.Depth) + 1;
}

/// <summary>Resolves the names in a formula.</summary>
internal interface IFormulaScope
{
    /// <summary>All names, for suggestions.</summary>
    IEnumerable<string> Names { get; }

    /// <summary>The variable of that name, or null.</summary>
    FormulaNode? Variable(string name, Token at);

    bool IsArray(string name);

    /// <summary>Names of its own functions, for suggestions.</summary>
    IEnumerable<string> Functions { get; }

    /// <summary>A call of one of its own functions, or null if it has no function of that name.</summary>
    FormulaNode? Call(Token name, List<FormulaNode> arguments);

    /// <summary>An element of the array of that name, or null.</summary>
    FormulaNode? Element(string name, FormulaNode index, Token at);
}
