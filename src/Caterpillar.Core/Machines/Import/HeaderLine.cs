namespace Caterpillar.Machines;

/// <summary>A word of a line: its letter, its value (NaN if missing or a name in braces) and the position of the value in the line.</summary>
internal readonly record struct HeaderWord(char Letter, double Value, int From, int To)
{
    public bool HasValue => To > From;
}

/// <summary>A line of a header or footer, split into words.</summary>
internal sealed class HeaderLine
{
    // These are followed by text or a file name, not words.
    private static readonly string[] TextCommands = ["M117", "M118", "M23", "M28", "M30", "M32", "M928"];

    private readonly List<HeaderWord> _words = [];

    private HeaderLine(string text) => Text = text;

    public string Text { get; }

    /// <summary>The command, such as <c>G1</c> or <c>M104</c>; empty for empty lines, comments and firmware macros.</summary>
    public string Command { get; private set; } = "";

    /// <summary>The words after the command.</summary>
    public IReadOnlyList<HeaderWord> Words => _words;

    /// <summary>The text after <c>;</c> or in parentheses.</summary>
    public string Comment { get; private set; } = "";

    /// <summary>Code and message of an error, and its column from 1.</summary>
    public (string Code, string Message, int Column)? Error { get; private set; }

    public bool IsCommand(params string[] commands) => Array.IndexOf(commands, Command) >= 0;

    public double? this[char letter] => _words.Where(w => w.Letter == letter).Select(w => (double?)w.Value).FirstOrDefault();

    public static HeaderLine Read(string text)
    {
        var line = new HeaderLine(text);
        line.Read();
        return line;
    }

    private void Read()
    {
        var at = 0;
        while (Next(ref at))
        {
            var from = at;
            var c = Upper(Text[at]);
            if (c == '*' && _words.Count > 0) return;
            if (c is < 'A' or > 'Z')
            {
                Bad(from, $"\"{Token(from)}\" has no letter in front of it.");
                return;
            }
            if (Command.Length == 0 && _words.Count == 0 && at + 1 < Text.Length && (Upper(Text[at + 1]) is >= 'A' and <= 'Z' or '_'))
                return;
            var word = Word(ref at, c);
            if (Command.Length == 0)
            {
                if (c == 'N' && word.HasValue) continue;
                if (c is not ('G' or 'M' or 'T' or 'D'))
                {
                    Error = ("header.no_command", $"\"{Text.Trim()}\" has no command. Did you mean G1 {Text.Trim()}?", from + 1);
                    return;
                }
                Command = c + (double.IsNaN(word.Value) ? "" : NumberFormatter.Format(word.Value, 3));
                if (c == 'T') _words.Add(word);
                if (Array.IndexOf(TextCommands, Command) >= 0) return;
                continue;
            }
            _words.Add(word);
            if (!word.HasValue && IsCommand("G0", "G1", "G2", "G3"))
            {
                Bad(from, $"{c} of {Command} has no number.");
                return;
            }
        }
    }

    private HeaderWord Word(ref int at, char letter)
    {
        var from = ++at;
        if (at < Text.Length && Text[at] is '{' or '"')
        {
            var close = Text.IndexOf(Text[at] == '{' ? '}' : '"', at + 1);
            at = close < 0 ? Text.Length : close + 1;
            return new HeaderWord(letter, double.NaN, from, at);
        }
        while (at < Text.Length && (Text[at] is >= '0' and <= '9' or '.' || (at == from && Text[at] is '+' or '-'))) at++;
        return new HeaderWord(letter, NumberReader.TryParse(Text.Substring(from, at - from), out var value) ? value : double.NaN, from, at);
    }

    private bool Next(ref int at)
    {
        while (at < Text.Length)
        {
            if (Text[at] == ';')
            {
                Comment += Text.Substring(at + 1);
                return false;
            }
            if (Text[at] == '(')
            {
                var close = Text.IndexOf(')', at);
                var end = close < 0 ? Text.Length : close + 1;
                Comment += Text.Substring(at + 1, Math.Max(0, end - at - 2)) + " ";
                at = end;
            }
            else if (Text[at] > ' ' && Text[at] != '\uFEFF')
            {
                return true;
            }
            else
            {
                at++;
            }
        }
        return false;
    }

    private void Bad(int at, string message) => Error = ("header.bad_word", message, at + 1);

    private string Token(int from)
    {
        var end = from;
        while (end < Text.Length && Text[end] > ' ' && Text[end] != ';') end++;
        return Text.Substring(from, Math.Min(end - from, 40));
    }

    private static char Upper(char c) => c is >= 'a' and <= 'z' ? (char)(c - 32) : c;
}
