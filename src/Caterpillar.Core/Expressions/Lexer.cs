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

    // One-letter texts without an allocation each.
    private static readonly Dictionary<char, string> Singles = "+-*/%^()[],;=<>!?:&|".ToDictionary(c => c, c => c.ToString());

    /// <exception cref="FormulaException">An invalid character, an unclosed string, a number out of range.</exception>
    public static List<Token> Read(string text)
    {
        var tokens = new List<Token>();
        var line = 1;
        var lineStart = 0;
        var space = true;
        var i = 0;
        while (i < text.Length)
        {
            var c = text[i];
            if (c is '\n' or '\r')
            {
                tokens.Add(new Token(TokenKind.NewLine, "\n", 0, line, i - lineStart + 1, space, true));
                if (c == '\r' && i + 1 < text.Length && text[i + 1] == '\n') i++;
                i++;
                line++;
                lineStart = i;
                space = true;
                continue;
            }
            if (char.IsWhiteSpace(c) || c == '\uFEFF')
            {
                i++;
                space = true;
                continue;
            }
            if (c == '#' || (c == '/' && i + 1 < text.Length && text[i + 1] == '/'))
            {
                while (i < text.Length && text[i] is not ('\n' or '\r')) i++;
                space = true;
                continue;
            }
            var column = i - lineStart + 1;
            var start = i;
            var kind = TokenKind.Symbol;
            var value = 0.0;
            string word;
            if (IsDigit(c) || (c == '.' && i + 1 < text.Length && IsDigit(text[i + 1])))
            {
                kind = TokenKind.Number;
                i = NumberEnd(text, i);
                word = text.Substring(start, i - start);
                if (!NumberReader.TryParse(word, out value)) throw new FormulaException("formula.number", $"'{word}' is not a number.", line, column);
                if (i < text.Length && (char.IsLetter(text[i]) || text[i] == '_'))
                    throw new FormulaException("formula.number", $"A letter directly follows the number {word}. Use * to multiply.", line, column);
            }
            else if (char.IsLetter(c) || c == '_')
            {
                kind = TokenKind.Name;
                while (i < text.Length && (char.IsLetterOrDigit(text[i]) || text[i] == '_')) i++;
                word = text.Substring(start, i - start);
            }
            else if (c == '"')
            {
                kind = TokenKind.Text;
                i++;
                while (i < text.Length && text[i] is not ('"' or '\n' or '\r')) i++;
                if (i >= text.Length || text[i] != '"') throw new FormulaException("formula.text", "The text has no closing quotation mark.", line, column);
                word = text.Substring(start + 1, i - start - 1);
                i++;
            }
            else
            {
                word = Symbol(text, ref i, line, column);
            }
            var after = i >= text.Length || char.IsWhiteSpace(text[i]);
            tokens.Add(new Token(kind, word, value, line, column, space, after));
            space = false;
        }
        tokens.Add(new Token(TokenKind.End, "", 0, line, text.Length - lineStart + 1, space, true));
        return tokens;
    }

    private static string Symbol(string text, ref int i, int line, int column)
    {
        var c = text[i];
        if (i + 1 < text.Length)
        {
            foreach (var pair in Pairs)
            {
                if (pair[0] != c || pair[1] != text[i + 1]) continue;
                i += 2;
                return pair;
            }
        }
        i++;
        // The typographic minus sign, as in text from the web.
        if (c == '\u2212') return "-";
        if (c is '\u00D7' or '\u00B7') return "*";
        return Singles.TryGetValue(c, out var single) ? single : throw new FormulaException("formula.character", $"Unexpected character '{c}'.", line, column);
    }

    private static int NumberEnd(string text, int i)
    {
        while (i < text.Length && (IsDigit(text[i]) || text[i] == '.')) i++;
        if (i >= text.Length || text[i] is not ('e' or 'E')) return i;
        var p = i + 1;
        if (p < text.Length && text[p] is '-' or '+') p++;
        if (p >= text.Length || !IsDigit(text[p])) return i;
        while (p < text.Length && IsDigit(text[p])) p++;
        return p;
    }

    private static bool IsDigit(char c) => c is >= '0' and <= '9';
}
