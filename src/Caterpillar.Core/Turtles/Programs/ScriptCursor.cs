namespace Caterpillar.Turtles;

/// <summary>A position in the tokens of a script or of an included file.</summary>
internal sealed class ScriptCursor(ScriptSource source)
{
    /// <summary>The current script or file.</summary>
    public ScriptSource Source { get; private set; } = source;

    /// <summary>Number of the next token.</summary>
    public int At { get; set; }

    public List<Token> Tokens => Source.Tokens;

    public Token Next => Source.Tokens[At];

    /// <summary>Works on the tokens of a file and comes back. Errors state the name of the file.</summary>
    public void Within(ScriptSource file, Action work)
    {
        var (outer, at) = (Source, At);
        (Source, At) = (file, 0);
        try
        {
            work();
        }
        catch (FormulaException e) when (e.File is null)
        {
            e.File = file.File;
            throw;
        }
        (Source, At) = (outer, at);
    }

    public void SkipLines()
    {
        while (Next.Kind == TokenKind.NewLine) At++;
    }

    /// <summary>Goes past a name.</summary>
    /// <exception cref="FormulaException">The next token is not a name.</exception>
    public Token TakeName(string message) => Next.Kind == TokenKind.Name ? Tokens[At++] : throw Error("turtle.syntax", message, Next);

    /// <summary>Goes past a symbol or word.</summary>
    /// <param name="word">The expected symbol or word.</param>
    /// <param name="example">Added to the message, or empty.</param>
    /// <param name="code">Code of the error.</param>
    /// <exception cref="FormulaException">Another token comes next.</exception>
    public void Expect(string word, string example = "", string code = "turtle.syntax")
    {
        if (!Next.Is(word) && !Next.IsWord(word)) throw Error(code, $"Found {Next}, expected '{word}'{(example.Length > 0 ? ": " + example : "")}.", Next);
        At++;
    }

    /// <exception cref="FormulaException">The statement goes on.</exception>
    public void ExpectEnd(string usage)
    {
        if (!EndsStatement(Next)) throw Error("turtle.values", $"Found {Next}, expected the end of the command: {usage}.", Next);
    }

    /// <summary>True if the token after one is a bracket without a space before it, as in a call.</summary>
    public bool IsBeforeBracket(int at) => Tokens[at + 1].Is("(") && !Tokens[at + 1].SpaceBefore;

    public static bool EndsStatement(Token t) => t.Kind is TokenKind.End or TokenKind.NewLine || t.Is(";") || t.Is("]");

    public static FormulaException Error(string code, string message, Token at) => new(code, message, at);
}
