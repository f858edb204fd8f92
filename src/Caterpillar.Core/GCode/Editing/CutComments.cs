using System.Collections.Generic;
using System.Linq;

namespace Caterpillar.GCode;

/// <summary>
/// Comments in front of moves that are cut out, as far as the moves behind the cut need them: where a layer begins, what strands are for, of which object. A
/// later comment of the same kind takes their place.
/// </summary>
internal sealed class CutComments
{
    private readonly List<CommentLine> _layer = [];
    private CommentLine? _role;
    private CommentLine? _object;

    public bool IsEmpty => _role is null && _object is null && _layer.Count == 0;

    /// <summary>A comment that goes.</summary>
    public void Cut(CommentLine line)
    {
        switch (Kind(line))
        {
            case CommentKind.LayerNumber:
            case CommentKind.LayerChange:
                _layer.Clear();
                _layer.Add(line);
                break;
            case CommentKind.Z:
            case CommentKind.Height:
                _layer.Add(line);
                break;
            case CommentKind.Role:
                _role = line;
                break;
            case CommentKind.ObjectStart:
            case CommentKind.ObjectEnd:
                _object = line;
                break;
        }
    }

    /// <summary>A comment that stays.</summary>
    public void Keep(CommentLine line)
    {
        switch (Kind(line))
        {
            case CommentKind.LayerNumber:
            case CommentKind.LayerChange:
                _layer.Clear();
                break;
            case CommentKind.Role:
                _role = null;
                break;
            case CommentKind.ObjectStart:
            case CommentKind.ObjectEnd:
                _object = null;
                break;
        }
    }

    /// <summary>What has to stand in front of a move that stays; forgotten afterwards.</summary>
    public IReadOnlyList<CommentLine> Take()
    {
        var lines = _layer.ToList();
        if (_object is { } of) lines.Add(of);
        if (_role is { } role) lines.Add(role);
        _layer.Clear();
        _role = _object = null;
        return lines;
    }

    private static CommentKind Kind(CommentLine line)
    {
        var at = line.Start;
        while (at < line.End && line.Text[at] <= ' ') at++;
        return at < line.End && line.Text[at] == ';' ? CommentReader.Read(line.Text, at, line.End).Kind : CommentKind.None;
    }
}

/// <summary>A line of the file that is nothing but a comment or blank.</summary>
internal readonly record struct CommentLine(byte[] Text, int Start, int End, int Next);
