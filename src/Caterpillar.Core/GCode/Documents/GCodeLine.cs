using System.Collections.Generic;
using System.Text;
using Caterpillar.Basics;

namespace Caterpillar.GCode;

/// <summary>A word of a line: a letter and a number.</summary>
/// <param name="Letter">Upper case.</param>
/// <param name="Value">Its number as written, or null for a bare letter (<c>G28 X</c>).</param>
public readonly record struct GCodeWord(char Letter, double? Value)
{
    public override string ToString() => Value is { } value ? Letter + NumberFormatter.Format(value, 6) : Letter.ToString();
}

/// <summary>One line of a <see cref="GCodeDocument"/>. Text and words are made when asked for.</summary>
public sealed class GCodeLine
{
    private static readonly Encoding Latin1 = Encoding.GetEncoding(28591);
    private readonly byte[] _buffer;
    private readonly int _start;
    private readonly int _end;
    private ParsedLine? _parsed;

    internal GCodeLine(int number, byte[] buffer, int start, int end)
    {
        Number = number;
        _buffer = buffer;
        _start = start;
        _end = end;
    }

    /// <summary>Number of the line, from 1.</summary>
    public int Number { get; }

    /// <summary>The line without its line end; each byte is one character (Latin-1).</summary>
    public string Text => Latin1.GetString(_buffer, _start, _end - _start);

    /// <summary>The words in order; none for a blank line, a comment or a macro. A leading line number is left out.</summary>
    public IReadOnlyList<GCodeWord> Words
    {
        get
        {
            var parsed = Parsed;
            var words = new GCodeWord[parsed.Count];
            for (var i = 0; i < words.Length; i++)
                words[i] = new GCodeWord((char)parsed.Letters[i], parsed.HasValue[i] ? parsed.Values[i] : null);
            return words;
        }
    }

    /// <summary>What follows a <c>;</c>, without it, or null.</summary>
    public string? Comment => Parsed.CommentStart < 0 ? null : Latin1.GetString(_buffer, Parsed.CommentStart + 1, _end - Parsed.CommentStart - 1);

    /// <summary>True for extended commands and lines that are not G-code: they begin with something other than a letter and a number.</summary>
    public bool IsMacro => Parsed.Shape == LineShape.Macro;

    public override string ToString() => Text;

    private ParsedLine Parsed
    {
        get
        {
            if (_parsed is not null) return _parsed;
            var parsed = new ParsedLine();
            parsed.Scan(_buffer, _start, _end);
            return _parsed = parsed;
        }
    }
}
