namespace Caterpillar.Expressions;

/// <summary>
/// A formula from text, compiled once to delegates. It supports numbers, variables, <c>+ - * / % ^</c>, comparisons, <c>and or not</c>, <c>a ? b : c</c>, the
/// constants <c>pi</c> and <c>tau</c> and the functions of <see cref="FormulaFunctions"/>. Angles are degrees. True is 1, false is 0. The same text gives the
/// same bits on every runtime. Division by zero gives infinities or NaN, as in all double arithmetic. The caller checks the value.
/// </summary>
internal sealed class Formula(string text, string[] variables, FormulaNode node, bool usesRandom)
{
    private readonly Evaluator _evaluate = node.Evaluate;

    /// <summary>The source text.</summary>
    public string Text { get; } = text;

    /// <summary>Names of the variables by slot.</summary>
    public IReadOnlyList<string> Variables { get; } = variables;

    /// <summary>True if the value does not depend on variables.</summary>
    public bool IsConstant { get; } = node.IsConstant;

    /// <summary>True if it draws from <see cref="FormulaContext.Random"/>, so that the order of evaluations matters.</summary>
    public bool UsesRandom { get; } = usesRandom;

    /// <summary>Compiles a formula.</summary>
    /// <param name="text">For example <c>10 + 2 * sin(3 * t)</c>.</param>
    /// <param name="variables">Names of variables, by slot.</param>
    /// <param name="source">Origin of the text. Diagnostics have its file and key, and line and column of the text.</param>
    public static Result<Formula> Compile(string text, IReadOnlyList<string>? variables = null, SourceLocation? source = null)
    {
        var names = (variables ?? []).ToArray();
        try
        {
            var tokens = Lexer.Read(text).Where(t => t.Kind != TokenKind.NewLine).ToList();
            var parser = new FormulaParser(tokens, 0, new SlotScope(names));
            var node = parser.Parse();
            parser.ExpectEnd();
            return new Result<Formula>(new Formula(text, names, node, parser.UsesRandom), []);
        }
        catch (FormulaException e)
        {
            return new Result<Formula>(e.Code, e.Message, (source ?? new SourceLocation()) with { Line = e.Line, Column = e.Column });
        }
    }

    /// <summary>The value for these values of the variables.</summary>
    /// <exception cref="ArgumentException">Fewer values than variables.</exception>
    public double Evaluate(params double[] values) => Evaluate(new FormulaContext(values));

    /// <summary>The value in a reusable context, without allocations.</summary>
    /// <exception cref="ArgumentException">Fewer values than variables.</exception>
    public double Evaluate(FormulaContext context)
    {
        if (context.Values.Length < Variables.Count) throw new ArgumentException("Fewer values than variables.", nameof(context));
        return _evaluate(context);
    }

    public override string ToString() => Text;

    private sealed class SlotScope(string[] names) : IFormulaScope
    {
        public IEnumerable<string> Names => names;

        public FormulaNode? Variable(string name, Token at)
        {
            var slot = Array.IndexOf(names, name);
            return slot < 0 ? null : new FormulaNode(c => c.Values[slot]);
        }

        public FormulaNode? Element(string name, FormulaNode index, Token at) => null;

        public bool IsArray(string name) => false;

        public IEnumerable<string> Functions => [];

        public FormulaNode? Call(Token name, List<FormulaNode> arguments) => null;
    }
}
