using System;
using System.IO;
using Caterpillar.Basics;

namespace Caterpillar.GCode;

/// <summary>Collects the bytes of a spliced file. Where lines are numbered, those behind an inserted or dropped line get new numbers and checksums.</summary>
internal sealed class SplicedText(Stream stream, LineStyle style)
{
    private readonly byte[] _buffer = new byte[1 << 16];
    private readonly ParsedLine _line = new();
    private int _count;
    private int _shift;
    private double _lastNumber;
    private bool _open;

    /// <summary>True while untouched lines can be copied as they are.</summary>
    public bool IsPlain => _shift == 0;

    public void Copy(byte[] text, int start, int end)
    {
        if (end <= start) return;
        _open = text[end - 1] != '\n' && text[end - 1] != '\r';
        if (end - start > _buffer.Length - _count)
        {
            Flush();
            if (end - start > _buffer.Length)
            {
                stream.Write(text, start, end - start);
                return;
            }
        }
        Buffer.BlockCopy(text, start, _buffer, _count, end - start);
        _count += end - start;
    }

    /// <summary>A line of the file with its own line end.</summary>
    public void Line(byte[] text, int start, int end, int next)
    {
        if (!style.Numbered)
        {
            Copy(text, start, next);
            return;
        }
        Line(text, start, end, text, end, next);
    }

    /// <summary>A changed line with the line end of the file's.</summary>
    public void Line(byte[] text, int start, int end, byte[] file, int lineEnd, int next)
    {
        if (style.Numbered) Numbered(text, start, end);
        else Copy(text, start, end);
        Copy(file, lineEnd, next);
    }

    /// <summary>A line that is put in.</summary>
    public void Own(byte[] text, int count)
    {
        CloseLine();
        if (style.Numbered && count > 0 && text[0] != ';')
        {
            _shift++;
            var made = new byte[count + 60];
            var at = WriteNumber(made, _lastNumber + 1);
            made[at++] = (byte)' ';
            Buffer.BlockCopy(text, 0, made, at, count);
            at = Checksum(made, at + count);
            _lastNumber++;
            Copy(made, 0, at);
        }
        else
        {
            Copy(text, 0, count);
        }
        Copy(style.LineEnd, 0, style.LineEnd.Length);
    }

    /// <summary>A line of the file that is left out.</summary>
    public void Dropped(ParsedLine line)
    {
        if (line.NumberWordAt >= 0) _shift--;
    }

    /// <summary>Ends the last line of a file that does not end it.</summary>
    public void CloseLine()
    {
        if (_open) Copy(style.LineEnd, 0, style.LineEnd.Length);
    }

    public void Flush()
    {
        stream.Write(_buffer, 0, _count);
        _count = 0;
    }

    private void Numbered(byte[] text, int start, int end)
    {
        _line.Scan(text, start, end);
        if (_line.NumberWordAt < 0)
        {
            Copy(text, start, end);
            return;
        }
        _lastNumber = _line.LineNumber + _shift;
        if (_shift == 0)
        {
            Copy(text, start, end);
            return;
        }
        var made = new byte[end - start + 60];
        var at = _line.NumberWordAt - start;
        Buffer.BlockCopy(text, start, made, 0, at);
        at += WriteNumber(made, _lastNumber, at) - at;
        var stop = _line.ChecksumAt >= 0 ? _line.ChecksumAt : end;
        Buffer.BlockCopy(text, _line.NumberWordEnd, made, at, stop - _line.NumberWordEnd);
        at += stop - _line.NumberWordEnd;
        if (_line.ChecksumAt >= 0)
        {
            at = Sum(made, at);
            stop++;
            while (stop < end && (uint)(text[stop] - '0') <= 9) stop++;
        }
        Buffer.BlockCopy(text, stop, made, at, end - stop);
        Copy(made, 0, at + end - stop);
    }

    private static int WriteNumber(byte[] made, double number, int at = 0)
    {
        made[at++] = (byte)'N';
        return NumberFormatter.WriteUnits(made, at, number is > -1e15 and < 1e15 ? (long)number : 0, 0);
    }

    private int Checksum(byte[] made, int count) => style.Checksums ? Sum(made, count) : count;

    private static int Sum(byte[] made, int count)
    {
        var sum = 0;
        for (var i = 0; i < count; i++) sum ^= made[i];
        made[count++] = (byte)'*';
        return NumberFormatter.WriteUnits(made, count, sum, 0);
    }
}
