using static Caterpillar.Turtles.ScriptCursor;

namespace Caterpillar.Turtles;

/// <summary>Reads the values of statements: formulas, lists of them, and texts with formulas.</summary>
internal sealed class ScriptValues(ScriptCursor cursor, ScriptNames names)
{
    private Token Next => cursor.Next;

    /// <summary>One of several values that spaces separate.</summary>
    public Argument Value(string command, string usage) => Read(parser => parser.ParseArgument(), $"'{command}' needs a value: {usage}.");

    /// <summary>A whole formula.</summary>
    public Argument Formula(string after) => Read(parser => parser.Parse(), $"'{after}' needs a value.");

    /// <summary>Values up to the end of the statement or the next command, separated by spaces or commas.</summary>
    public Argument?[] Values(int required, int max, bool mayKeep, Token command, string usage)
    {
        var values = new List<Argument?>();
        while (values.Count < max)
        {
            if (Next.Is(",") && values.Count > 0) cursor.At++;
            else if (!BeginsValue(Next)) break;
            if (Next.IsWord("keep"))
            {
                if (!mayKeep || values.Count >= 3) throw Error("turtle.values", "'keep' is only for the coordinates of 'position' and 'jump'.", Next);
                values.Add(null);
                cursor.At++;
                continue;
            }
            values.Add(Value(command.Text, usage));
        }
        if (values.Count < required)
        {
            if (Next.Kind == TokenKind.Name && !Next.IsWord("keep") && (!names.BeginsStatement(Next) || cursor.IsBeforeBracket(cursor.At)))
                Value(command.Text, usage);
            throw Error("turtle.values", $"'{command.Text}' needs {Count(required)}: {usage}.", command);
        }
        if (Next.Kind != TokenKind.Name) cursor.ExpectEnd(usage);
        return values.ToArray();
    }

    /// <summary>The values of a call: in brackets, or separated by spaces.</summary>
    public Argument?[] OfCall(int count, Token name, string usage) => IsList() ? List(count, name, usage) : Values(count, count, false, name, usage);

    public bool BeginsValue(Token t) => t.Kind switch
    {
        TokenKind.Number => true,
        TokenKind.Symbol => t.Text is "(" or "-" or "+" or "!",
        TokenKind.Name => t.Text is "keep" or "not" or "pi" or "tau" || names.Scope.Variable(t.Text, t) is not null || names.Scope.IsArray(t.Text)
            || (FormulaFunctions.Knows(t.Text) && !names.BeginsStatement(t)) || IsCall(t),
        _ => false,
    };

    /// <summary>The formulas in a text.</summary>
    public TextTemplate Template(Token token)
    {
        var texts = new List<string>();
        var values = new List<Argument>();
        var text = token.Text;
        var from = 0;
        while (true)
        {
            var open = text.IndexOf("{", from, StringComparison.Ordinal);
            var close = open < 0 ? -1 : text.IndexOf("}", open, StringComparison.Ordinal);
            if (close < 0)
            {
                texts.Add(text.Substring(from));
                return new TextTemplate(texts, values);
            }
            texts.Add(text.Substring(from, open - from));
            try
            {
                var parser = new FormulaParser(Lexer.Read(text.Substring(open + 1, close - open - 1)), 0, names.Scope);
                values.Add(new Argument(parser.Parse(), token));
                parser.ExpectEnd();
            }
            catch (FormulaException e)
            {
                throw new FormulaException(e.Code, e.Message, token.Line, token.Column + 1 + open + e.Column);
            }
            from = close + 1;
        }
    }

    private Argument Read(Func<FormulaParser, FormulaNode> parse, string missing)
    {
        var at = Next;
        if (EndsStatement(at)) throw Error("turtle.values", missing, at);
        var parser = new FormulaParser(cursor.Tokens, cursor.At, names.Scope);
        var node = parse(parser);
        cursor.At = parser.At;
        return new Argument(node, at);
    }

    // name(1, 2) or name(), as in a formula; name (1 + 2) has one value in brackets.
    private bool IsList()
    {
        if (!Next.Is("(") || Next.SpaceBefore) return false;
        var tokens = cursor.Tokens;
        if (tokens[cursor.At + 1].Is(")")) return true;
        var depth = 0;
        for (var i = cursor.At; i < tokens.Count && tokens[i].Kind is not (TokenKind.NewLine or TokenKind.End); i++)
        {
            if (tokens[i].Is("(")) depth++;
            else if (tokens[i].Is(")") && --depth == 0) break;
            else if (tokens[i].Is(",") && depth == 1) return true;
        }
        return false;
    }

    private Argument?[] List(int count, Token name, string usage)
    {
        var open = Next;
        var values = new List<Argument?>();
        do
        {
            cursor.At++;
            if (Next.Is(")") && values.Count == 0) break;
            values.Add(Formula(name.Text));
        }
        while (Next.Is(","));
        if (!Next.Is(")")) throw Error("formula.bracket", $"Found {Next}, expected ')'.", open);
        cursor.At++;
        if (values.Count != count) throw Error("turtle.values", $"'{name.Text}' needs {Count(count)}: {usage}.", name);
        return values.ToArray();
    }

    // A function directly before its '('; with a space it is a statement.
    private bool IsCall(Token t) => names.Scope.IsFunction(t.Text) && cursor.IsBeforeBracket(cursor.At);

    private static string Count(int n) => n == 1 ? "one value" : $"{NumberFormatter.Format(n)} values";
}
