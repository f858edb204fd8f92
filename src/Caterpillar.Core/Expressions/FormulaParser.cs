namespace Caterpillar.Expressions;

/// <summary>Recursive descent over tokens. Scripts may start it at any token. It stops after the formula.</summary>
internal sealed class FormulaParser(List<Token> tokens, int at, IFormulaScope scope)
{
    // Keeps parsing and evaluation from overflowing any thread's stack.
    private const int MaxDepth = 250;

    private static readonly string[] Words = ["and", "or", "not"];

    private int _depth;

    // Inside an argument of a script's command (not in parentheses) " -3" begins the next argument.
    private bool _argument;

    /// <summary>Index of the next token.</summary>
    public int At { get; private set; } = at;

    public bool UsesRandom { get; private set; }

    private Token Next => tokens[At];

    /// <summary>One formula.</summary>
    public FormulaNode Parse() => Complete(argument: false);

    /// <summary>One of several arguments separated by spaces. A minus or plus with a space only before it begins the next argument, as in Logo.</summary>
    public FormulaNode ParseArgument() => Complete(argument: true);

    public void ExpectEnd()
    {
        if (Next.Kind != TokenKind.End) throw Unexpected(Next, "an operator or the end of the formula");
    }

    private FormulaNode Complete(bool argument)
    {
        var before = _argument;
        _argument = argument;
        var node = Choice();
        _argument = before;
        return node;
    }

    private FormulaNode Choice()
    {
        var at = Next;
        if (++_depth > MaxDepth) throw TooDeep(at);
        var node = Or();
        if (Next.Is("?"))
        {
            At++;
            var yes = Choice();
            if (!Next.Is(":")) throw Unexpected(Next, "':' of 'condition ? value : value'");
            At++;
            node = Checked(FormulaNode.Choice(node, yes, Choice()), at);
        }
        _depth--;
        return node;
    }

    private FormulaNode Or()
    {
        var node = And();
        while (Next.IsWord("or") || Next.Is("||")) node = Binary("or", node, 0);
        return node;
    }

    private FormulaNode And()
    {
        var node = Not();
        while (Next.IsWord("and") || Next.Is("&&")) node = Binary("and", node, 1);
        return node;
    }

    private FormulaNode Not()
    {
        var count = 0;
        while (Next.IsWord("not") || Next.Is("!"))
        {
            At++;
            count++;
        }
        var node = Comparison();
        if (count == 0) return node;
        return FormulaNode.Of(node, count % 2 == 1 ? x => x == 0 ? 1 : 0 : x => x != 0 ? 1 : 0);
    }

    private FormulaNode Comparison()
    {
        var node = Sum();
        if (Next.Is("=")) throw new FormulaException("formula.syntax", "'=' does not compare. Use '=='.", Next);
        if (!IsComparison(Next)) return node;
        node = Binary(Next.Text, node, 3);
        if (IsComparison(Next)) throw new FormulaException("formula.syntax", "Comparisons cannot be chained. Join them with 'and'.", Next);
        return node;
    }

    private FormulaNode Sum()
    {
        var node = Product();
        while ((Next.Is("+") || Next.Is("-")) && !(_argument && Next.SpaceBefore && !Next.SpaceAfter)) node = Binary(Next.Text, node, 4);
        return node;
    }

    private FormulaNode Product()
    {
        var node = Sign();
        while (Next.Is("*") || Next.Is("/") || Next.Is("%")) node = Binary(Next.Text, node, 5);
        return node;
    }

    private FormulaNode Sign()
    {
        var negative = false;
        while (Next.Is("-") || Next.Is("+"))
        {
            negative ^= Next.Is("-");
            At++;
        }
        var node = Power();
        return negative ? FormulaNode.Of(node, x => -x) : node;
    }

    private FormulaNode Power()
    {
        var node = Primary();
        if (!Next.Is("^")) return node;
        var at = Next;
        At++;
        if (++_depth > MaxDepth) throw TooDeep(at);
        node = Checked(FormulaNode.Binary("^", node, Sign()), at);
        _depth--;
        return node;
    }

    private FormulaNode Binary(string symbol, FormulaNode left, int level)
    {
        var at = Next;
        At++;
        var right = level switch { 0 => And(), 1 => Not(), 3 => Sum(), 4 => Product(), _ => Sign() };
        return Checked(FormulaNode.Binary(symbol, left, right), at);
    }

    private FormulaNode Primary()
    {
        var token = Next;
        switch (token.Kind)
        {
            case TokenKind.Number:
                At++;
                return new FormulaNode(token.Value);
            case TokenKind.Symbol when token.Text == "(":
                At++;
                var inner = Complete(argument: false);
                Close(")", token);
                return inner;
            case TokenKind.Name when !Words.Contains(token.Text):
                At++;
                return Named(token);
            default:
                throw Unexpected(token, "a number, a name or '('");
        }
    }

    private FormulaNode Named(Token name)
    {
        if (scope.IsArray(name.Text) && Next.Is("[") && !Next.SpaceBefore)
        {
            var open = Next;
            At++;
            var index = Complete(argument: false);
            Close("]", open);
            return Checked(scope.Element(name.Text, index, name)!, name);
        }
        // A variable hides a function or constant of the same name.
        if (scope.Variable(name.Text, name) is { } variable)
        {
            if (Next.Is("(") && !Next.SpaceBefore)
            {
                throw new FormulaException("formula.unknown", $"'{name.Text}' is a variable, not a function.", name);
            }
            return variable;
        }
        if (Next.Is("(") && (FormulaFunctions.Knows(name.Text) || scope.Functions.Contains(name.Text))) return Call(name);
        if (name.Text == "pi") return new FormulaNode(System.Math.PI);
        if (name.Text == "tau") return new FormulaNode(2 * System.Math.PI);
        if (FormulaFunctions.Knows(name.Text)) throw new FormulaException("formula.syntax", $"The function '{name.Text}' needs '('.", name);
        if (scope.IsArray(name.Text))
            throw new FormulaException("formula.syntax", $"'{name.Text}' is an array. Use {name.Text}[index].", name);
        var function = Next.Is("(") && !Next.SpaceBefore;
        var known = function ? scope.Functions.Concat(FormulaFunctions.Names) : scope.Names.Concat(["pi", "tau"]).Concat(FormulaFunctions.Names);
        throw new FormulaException("formula.unknown",
            $"Unknown {(function ? "function" : "variable")} '{name.Text}'.{SpellingSuggestion.Hint(name.Text, known)}", name);
    }

    private FormulaNode Call(Token name)
    {
        var open = Next;
        At++;
        var arguments = new List<FormulaNode>();
        if (!Next.Is(")"))
        {
            arguments.Add(Complete(argument: false));
            while (Next.Is(","))
            {
                At++;
                arguments.Add(Complete(argument: false));
            }
        }
        Close(")", open);
        if (arguments.Count > 64) throw TooDeep(name);
        UsesRandom |= name.Text == "randint" || (name.Text == "random" && arguments.Count != 1);
        return Checked(scope.Call(name, arguments) ?? FormulaFunctions.Call(name, arguments), name);
    }

    private void Close(string bracket, Token open)
    {
        if (!Next.Is(bracket))
        {
            var unclosed = Next.Kind is TokenKind.End or TokenKind.NewLine || Next.Is(";") || Next.Is("[");
            var at = unclosed ? open : Next;
            throw new FormulaException(
                "formula.bracket", unclosed ? $"'{open.Text}' has no closing '{bracket}'." : $"Found {Next}, expected '{bracket}'.", at);
        }
        At++;
    }

    private static bool IsComparison(Token t) => t.Kind == TokenKind.Symbol && t.Text is "<" or ">" or "<=" or ">=" or "==" or "!=" or "<>";

    private static FormulaNode Checked(FormulaNode node, Token at) => node.Depth > 4 * MaxDepth ? throw TooDeep(at) : node;

    private static FormulaException TooDeep(Token at) => new("formula.too_long", "The formula is too long or too deeply nested.", at);

    private static FormulaException Unexpected(Token token, string expected)
        => new("formula.syntax", $"Found {token}, expected {expected}.", token);
}
