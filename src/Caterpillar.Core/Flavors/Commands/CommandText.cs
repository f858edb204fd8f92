namespace Caterpillar.Flavors;

/// <summary>A command in a line of G-code: its name, and the words after it. Nothing is copied.</summary>
internal readonly struct CommandText
{
    private const uint FirstHash = 2166136261;
    private const uint HashFactor = 16777619;
    private readonly byte[] _text;
    private readonly int _start;

    // The name is the first character and those from here on: leading zeros are left out.
    private readonly int _rest;
    private readonly int _nameEnd;
    private readonly int _end;

    /// <param name="text">The text.</param>
    /// <param name="start">Start of the command.</param>
    /// <param name="end">End of the code of its line, before a comment.</param>
    public CommandText(byte[] text, int start, int end)
    {
        while (start < end && text[start] <= ' ') start++;
        (_text, _start, _end) = (text, start, end);
        _rest = _nameEnd = Math.Min(start + 1, end);
        IsCode = start < end && (text[start] & 0xDF) is >= 'A' and <= 'Z' && ReadNumber(text, start + 1, end, out _rest, out _nameEnd);
        if (IsCode) return;
        _rest = Math.Min(start + 1, end);
        while (_nameEnd < end && text[_nameEnd] > ' ' && text[_nameEnd] is not ((byte)'*' or (byte)';' or (byte)'=')) _nameEnd++;
    }

    /// <summary>True for a letter with a number. Otherwise the name of an extended command.</summary>
    public bool IsCode { get; }

    /// <summary>Number of characters of the name.</summary>
    public int Length => _start >= _end ? 0 : 1 + _nameEnd - _rest;

    /// <summary>A character of the name, as a capital.</summary>
    public char this[int index]
    {
        get
        {
            var c = (char)_text[index == 0 ? _start : _rest + index - 1];
            return c is >= 'a' and <= 'z' ? (char)(c - 32) : c;
        }
    }

    /// <summary>A hash of the first characters of the name.</summary>
    public uint Hash(int length)
    {
        var hash = FirstHash;
        for (var i = 0; i < length; i++) hash = (hash ^ this[i]) * HashFactor;
        return hash;
    }

    /// <summary>The same of a name in capitals, without leading zeros.</summary>
    public static uint HashOf(string name)
    {
        var hash = FirstHash;
        foreach (var c in name) hash = (hash ^ c) * HashFactor;
        return hash;
    }

    /// <summary>True if the name begins with the first of these capitals.</summary>
    public bool Begins(string name, int length)
    {
        if (length > Length) return false;
        for (var i = 0; i < length; i++)
        {
            if (this[i] != name[i]) return false;
        }
        return true;
    }

    /// <summary>True if the words of the line are as <see cref="FlavorCommand.When"/> requires.</summary>
    public bool Fits(string when)
    {
        for (var at = 0; at < when.Length; at++)
        {
            var end = when.IndexOf(' ', at);
            if (end < 0) end = when.Length;
            if (!Fits(when, at, end)) return false;
            at = end;
        }
        return true;
    }

    private bool Fits(string when, int from, int to)
    {
        if (when[from] == '~') return Contains(when, from + 1, to);
        if (when[from] == '!') return !Has(when[from + 1], -1);
        var number = to == from + 1 ? -1 : 0;
        for (var i = from + 1; i < to; i++) number = 10 * number + when[i] - '0';
        return Has(when[from], number);
    }

    // A word with this letter, and with this number if it is not negative.
    private bool Has(char letter, int number)
    {
        for (var at = _nameEnd; at < _end; at++)
        {
            if (_text[at] == '"')
            {
                at = Array.IndexOf(_text, (byte)'"', at + 1, _end - at - 1);
                if (at < 0) return false;
            }
            else if ((_text[at] & 0xDF) == letter && (number < 0 || (NumberReader.Scan(_text, at + 1, _end, false, out var value) > at + 1 && value == number)))
            {
                return true;
            }
        }
        return false;
    }

    private bool Contains(string when, int from, int to)
    {
        for (var at = _nameEnd; at + to - from <= _end; at++)
        {
            var same = 0;
            while (same < to - from && (_text[at + same] | 0x20) == (when[from + same] | 0x20)) same++;
            if (same == to - from) return true;
        }
        return false;
    }

    // The digits of a number without leading zeros, and its fraction if that is not zero.
    private static bool ReadNumber(byte[] text, int at, int end, out int digits, out int numberEnd)
    {
        while (at < end && text[at] is (byte)' ' or (byte)'\t') at++;
        digits = at;
        if (at < end && text[at] == '-') at++;
        while (at + 1 < end && text[at] == '0' && IsDigit(text[at + 1])) digits = ++at;
        var first = at;
        while (at < end && IsDigit(text[at])) at++;
        numberEnd = at;
        if (at == first) return false;
        if (at < end && text[at] == '.')
        {
            var isZero = true;
            for (at++; at < end && IsDigit(text[at]); at++) isZero &= text[at] == '0';
            if (!isZero) numberEnd = at;
        }
        return at == end || text[at] != '_';
    }

    private static bool IsDigit(byte c) => (uint)(c - '0') <= 9;
}
