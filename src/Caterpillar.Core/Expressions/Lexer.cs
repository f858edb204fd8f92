namespace Caterpillar.Expressions;

internal enum TokenKind : byte
{
    Number,
    Name,
    Text,
    Symbol,
    NewLine,
    End,
}

/// <summary>A word of a formula or a script. Lines and columns count from 1.</summary>
internal readonly record struct Token(TokenKind Kind, string Text, double Value, int Line, int Column, bool SpaceBefore, bool SpaceAfter)
{
    public bool Is(string symbol) => Kind == TokenKind.Symbol && Text == symbol;

    public bool IsWord(string word) => Kind == TokenKind.Name && Text == word;

    public override string ToString() => Kind switch
    {
        TokenKind.End => "the end",
        TokenKind.NewLine => "the end of the line",
        TokenKind.Text => "\"" + Text + "\"",
        _ => "'" + Text + "'",
    };
}

/// <summary>Splits text into tokens. Comments begin with # or // and end with the line.</summary>
internal static class Lexer
{
    private static readonly string[] Pairs = ["==", "!=", "<>", "<=", ">=", "&&", "||", "+=", "-=", "*=", "/=", "->"];

    // One-letter texts without an allocation each. Typographic signs, as in text from the web, are those of the keyboard.
    private static readonly Dictionary<char, string> Singles = "+-*/%^()[],;=<>!?:&|".ToDictionary(c => c, c => c.ToString())
        .Concat(new Dictionary<char, string> { ['\u2212'] = "-", ['\u00D7'] = "*", ['\u00B7'] = "*" }).ToDictionary(c => c.Key, c => c.Value);

    /// <exception cref="FormulaException">An invalid character, an unclosed string, a number out of range.</exception>
    public static List<Token> Read(string text)
    {
        var tokens = new List<Token>();
        var (line, lineStart, space) = (1, 0, true);
        for (var i = 0; i < text.Length;)
        {
            var (c, column) = (text[i], i - lineStart + 1);
            var next = i + 1 < text.Length ? text[i + 1] : '\0';
            var before = space;
            space = true;
            if (c is '\n' or '\r')
            {
                tokens.Add(new Token(TokenKind.NewLine, "\n", 0, line++, column, before, true));
                lineStart = i += c == '\r' && next == '\n' ? 2 : 1;
            }
            else if (c == '#' || (c == '/' && next == '/')) i = End(text, i, d => d is not ('\n' or '\r'));
            else if (char.IsWhiteSpace(c) || c == '\uFEFF') i++;
            else
            {
                var (kind, word, value) = Word(text, ref i, line, column);
                tokens.Add(new Token(kind, word, value, line, column, before, i >= text.Length || char.IsWhiteSpace(text[i])));
                space = false;
            }
        }
        tokens.Add(new Token(TokenKind.End, "", 0, line, text.Length - lineStart + 1, space, true));
        return tokens;
    }

    private static (TokenKind Kind, string Text, double Value) Word(string text, ref int i, int line, int column)
    {
        var (c, start) = (text[i], i);
        if (char.IsLetter(c) || c == '_')
        {
            i = End(text, i, d => char.IsLetterOrDigit(d) || d == '_');
            return (TokenKind.Name, text.Substring(start, i - start), 0);
        }
        if (IsDigit(c) || (c == '.' && i + 1 < text.Length && IsDigit(text[i + 1])))
        {
            i = NumberEnd(text, i);
            var word = text.Substring(start, i - start);
            if (!NumberReader.TryParse(word, out var value)) throw new FormulaException("formula.number", $"'{word}' is not a number.", line, column);
            if (i < text.Length && (char.IsLetter(text[i]) || text[i] == '_'))
                throw new FormulaException("formula.number", $"A letter directly follows the number {word}. Use * to multiply.", line, column);
            return (TokenKind.Number, word, value);
        }
        if (c == '"')
        {
            i = End(text, i + 1, d => d is not ('"' or '\n' or '\r')) + 1;
            if (i > text.Length || text[i - 1] != '"') throw new FormulaException("formula.text", "The text has no closing quotation mark.", line, column);
            return (TokenKind.Text, text.Substring(start + 1, i - start - 2), 0);
        }
        var pair = Array.Find(Pairs, p => string.CompareOrdinal(text, start, p, 0, 2) == 0);
        i += pair is null ? 1 : 2;
        if (pair is null && !Singles.TryGetValue(c, out pair)) throw new FormulaException("formula.character", $"Unexpected character '{c}'.", line, column);
        return (TokenKind.Symbol, pair!, 0);
    }

    private static int NumberEnd(string text, int i)
    {
        i = End(text, i, d => IsDigit(d) || d == '.');
        if (i >= text.Length || text[i] is not ('e' or 'E')) return i;
        var digits = i + (i + 1 < text.Length && text[i + 1] is '-' or '+' ? 2 : 1);
        return digits < text.Length && IsDigit(text[digits]) ? End(text, digits, IsDigit) : i;
    }

    // The first place from one on whose character is of another kind.
    private static int End(string text, int i, Func<char, bool> isKind)
    {
        while (i < text.Length && isKind(text[i])) i++;
        return i;
    }

    private static bool IsDigit(char c) => c is >= '0' and <= '9';
}
