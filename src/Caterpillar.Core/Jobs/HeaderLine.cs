namespace Caterpillar.Jobs;

/// <summary>A line of start or end code. Names in braces stand for numbers, and are read as 0.</summary>
internal sealed class HeaderLine
{
    private readonly ParsedLine _line = new();

    public HeaderLine(string text)
    {
        Text = text;
        // One byte for each character, so that positions are the same in both.
        Plain = Regex.Replace(Regex.Replace(text, @"\{[^}]*\}?", name => "0".PadRight(name.Length)), @"[^\x00-\x7F]", "?");
        var bytes = TextEncoding.Encode(Plain);
        _line.Scan(bytes, 0, bytes.Length);
    }

    public string Text { get; }

    /// <summary>The text without names in braces, for decoding.</summary>
    public string Plain { get; }

    /// <summary>The text from the comment on, or empty.</summary>
    public string Comment => Text.Substring(_line.CommentStart >= 0 ? _line.CommentStart : _line.ParenStart >= 0 ? _line.ParenStart : Text.Length);

    /// <summary>The temperature above 0 that it sets with a number, °C.</summary>
    public double? Temperature => this['S'] is > 0 and <= 2000 and var set ? set : this['R'] is > 0 and <= 2000 and var reach ? reach : null;

    public double? this[char letter] => _line.TryGet(letter, out var value) ? value : null;

    public bool Has(char letter) => _line.Has(letter);

    /// <summary>True for a command with one of these numbers.</summary>
    public bool Is(char letter, params double[] numbers)
        => _line.Shape == LineShape.Code && _line.Letters[0] == letter && _line.HasValue[0] && Array.IndexOf(numbers, _line.Values[0]) >= 0;

    /// <summary>The text before and after the number of a word.</summary>
    public (string Before, string After) Around(char letter)
    {
        var word = _line.Find(letter);
        return (Text.Substring(0, _line.NumberAt[word]), Text.Substring(_line.NumberEnd[word]));
    }

    /// <summary>Code and message of an error, and its column from 1.</summary>
    public (string Code, string Message, int Column)? Error()
    {
        if (_line.Shape == LineShape.Macro && !char.IsLetter(Plain[_line.CodeStart]) && Plain[_line.CodeStart] != '_') return NoLetter(_line.CodeStart);
        if (_line.Shape != LineShape.Code) return null;
        if (_line.Letters[0] is not ((byte)'G' or (byte)'M' or (byte)'T' or (byte)'D'))
            return ("header.no_command", $"\"{Text.Trim()}\" has no command. Did you mean G1 {Text.Trim()}?", _line.LetterAt[0] + 1);
        for (var i = 0; i < _line.Count; i++)
        {
            if (!_line.HasValue[i] && Is('G', 0, 1, 2, 3))
                return ("header.bad_word", $"{(char)_line.Letters[i]} of {Text.Trim().Split(' ')[0]} has no number.", _line.LetterAt[i] + 1);
            var between = Plain.Substring(_line.NumberEnd[i], (i + 1 < _line.Count ? _line.LetterAt[i + 1] : _line.CodeEnd) - _line.NumberEnd[i]);
            // Texts, names of files and comments are no words.
            var isText = (_line.Count == 1 && _line.Letters[0] == 'M') || _line.ParenStart >= 0 || between.IndexOf('"', 0) >= 0;
            if (between.Trim().Length > 0 && !isText) return NoLetter(_line.NumberEnd[i] + between.Length - between.TrimStart().Length);
        }
        return null;
    }

    private (string, string, int) NoLetter(int at)
    {
        var word = Text.Substring(at).Split(' ', ';')[0];
        return ("header.bad_word", $"\"{word.Substring(0, Math.Min(word.Length, 40))}\" has no letter in front of it.", at + 1);
    }
}
