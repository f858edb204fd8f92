using static Caterpillar.Turtles.ScriptCursor;

namespace Caterpillar.Turtles;

/// <summary>The names of a script. Procedures, globals, arrays and images are visible everywhere, even before their line.</summary>
internal sealed class ScriptNames
{
    private static readonly string[] ShapingWords = ["deform", "modulate", "gap_bead", "cool_layers"];

    private static readonly string[] Keywords =
    [
        "repeat", "for", "to", "step", "if", "else", "while", "break", "let", "param", "array", "seed", "def", "return", "stop", "lsystem", "use", "keep",
        "and", "or", "not", "print", "include", "image", .. ShapingWords,
    ];

    private readonly ScriptCursor _cursor;

    /// <summary>Declares the names of a script and of its included files.</summary>
    /// <exception cref="FormulaException">A name is reserved, or declared twice.</exception>
    public ScriptNames(ScriptCursor cursor)
    {
        _cursor = cursor;
        Scope = new ScriptScope(Procedures);
        Declare(cursor.Source);
        DeclareValues(cursor.Source);
    }

    public Dictionary<string, Procedure> Procedures { get; } = new(StringComparer.Ordinal);

    public ScriptScope Scope { get; }

    public bool BeginsStatement(Token t)
        => Procedures.ContainsKey(t.Text) || TurtleCommands.Find(t.Text) is not null || (Keywords.Contains(t.Text) && t.Text is not ("keep" or "not"));

    /// <summary>True if a value follows the word 'return'.</summary>
    public bool IsValueAfterReturn(int at)
    {
        var token = _cursor.Tokens[at];
        return token.Kind switch
        {
            TokenKind.Number => true,
            TokenKind.Symbol => token.Text is "(" or "-" or "+" or "!",
            TokenKind.Name => !BeginsStatement(token) || _cursor.IsBeforeBracket(at),
            _ => false,
        };
    }

    public bool IsSmooth(int at) => at < _cursor.Tokens.Count && _cursor.Tokens[at].IsWord("smooth");

    /// <summary>The error for a name that does not begin a statement.</summary>
    public FormulaException Unknown(Token token)
    {
        if (Scope.Variable(token.Text, token) is not null)
            return Error("turtle.syntax", $"'{token.Text}' is a variable. Expected a command or '{token.Text} = …'.", token);
        var names = Procedures.Keys.Concat(TurtleCommands.Names)
            .Concat(Keywords.Where(k => k is not ("to" or "step" or "else" or "keep" or "and" or "or" or "not")));
        return Error("turtle.unknown", $"Unknown command '{token.Text}'.{SpellingSuggestion.Hint(token.Text, names)}", token);
    }

    private void Declare(ScriptSource source)
    {
        _cursor.Within(source, () =>
        {
            var tokens = source.Tokens;
            var depth = 0;
            var procedure = -1;
            for (var i = 0; i + 1 < tokens.Count; i++)
            {
                var token = tokens[i];
                var next = tokens[i + 1];
                if (token.Is("[")) depth++;
                else if (token.Is("]") && --depth == procedure) procedure = -1;
                if (source.Includes.TryGetValue(i, out var included) && included is not null) Declare(included);
                if (ShapingWords.Contains(token.Text) && token.Kind == TokenKind.Name)
                {
                    // The names of its values are no variables of the script.
                    while (i + 2 < tokens.Count && !tokens[i + 1].Is("[")) i++;
                }
                else if (token.IsWord("def") && procedure < 0)
                {
                    if (next.Kind == TokenKind.Name) DeclareProcedure(tokens, i + 1);
                    procedure = depth;
                }
                else if (token.IsWord("array") && next.Kind == TokenKind.Name)
                {
                    NewName(next, "array");
                    Scope.DeclareArray(next.Text);
                }
                else if (token.IsWord("image") && next.Kind == TokenKind.Name && source.Images.TryGetValue(i + 2, out var image))
                {
                    NewName(next, "image");
                    if (!Scope.DeclareImage(next.Text, image, IsSmooth(i + 3)))
                        throw Error("turtle.name", $"The image '{next.Text}' is declared twice.", next);
                }
                else if (procedure < 0 && token.Kind == TokenKind.Name && next.Is("="))
                {
                    NewName(token, "variable");
                    Scope.DeclareGlobal(token.Text);
                }
            }
        });
    }

    private void DeclareProcedure(List<Token> tokens, int at)
    {
        var name = tokens[at];
        NewName(name, "procedure");
        if (TurtleCommands.Find(name.Text) is not null)
            throw Error("turtle.name", $"'{name.Text}' is already a command. Choose another name for the procedure.", name);
        if (Procedures.ContainsKey(name.Text)) throw Error("turtle.name", $"The procedure '{name.Text}' is defined twice.", name);
        var parameters = new List<string>();
        for (var i = at + 1; tokens[i].Kind == TokenKind.Name || tokens[i].Is(","); i++)
        {
            if (tokens[i].Kind != TokenKind.Name) continue;
            NewName(tokens[i], "parameter");
            if (parameters.Contains(tokens[i].Text)) throw Error("turtle.name", $"The parameter '{tokens[i].Text}' is declared twice.", tokens[i]);
            parameters.Add(tokens[i].Text);
        }
        Procedures.Add(name.Text, new Procedure(name.Text, parameters));
    }

    // Which procedures return a value: only when all names are known, a name after 'return' can be told from the next command.
    private void DeclareValues(ScriptSource source)
    {
        _cursor.Within(source, () =>
        {
            var tokens = source.Tokens;
            Procedure? procedure = null;
            for (var i = 0; i + 1 < tokens.Count; i++)
            {
                if (source.Includes.TryGetValue(i, out var included) && included is not null) DeclareValues(included);
                if (tokens[i].IsWord("def")) Procedures.TryGetValue(tokens[i + 1].Text, out procedure);
                else if (procedure is not null && tokens[i].IsWord("return") && IsValueAfterReturn(i + 1)) procedure.ReturnsValue = true;
            }
        });
    }

    private static void NewName(Token name, string kind)
    {
        if (Keywords.Contains(name.Text) || ScriptScope.IsState(name.Text))
            throw Error("turtle.name", $"'{name.Text}' is a reserved name. Choose another name for the {kind}.", name);
    }
}
