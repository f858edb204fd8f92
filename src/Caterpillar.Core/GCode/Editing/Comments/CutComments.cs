namespace Caterpillar.GCode;

/// <summary>
/// Comments of cut moves that the moves after the cut need: the start of a layer, the role of extrusions, their object. A later comment of the same kind
/// replaces them.
/// </summary>
internal sealed class CutComments
{
    private readonly List<FileLine> _layer = [];
    private FileLine? _role;
    private FileLine? _object;

    public bool IsEmpty => _role is null && _object is null && _layer.Count == 0;

    /// <summary>Cuts a comment.</summary>
    public void Cut(FileLine line) => Replace(Kind(line), line);

    /// <summary>Keeps a comment.</summary>
    public void Keep(FileLine line) => Replace(Kind(line), null);

    /// <summary>Returns and removes the comments that must come before a kept move.</summary>
    public IReadOnlyList<FileLine> Take()
    {
        var lines = _layer.ToList();
        if (_object is { } of) lines.Add(of);
        if (_role is { } role) lines.Add(role);
        _layer.Clear();
        _role = _object = null;
        return lines;
    }

    private void Replace(CommentKind kind, FileLine? line)
    {
        switch (kind)
        {
            case CommentKind.LayerNumber or CommentKind.LayerChange:
                _layer.Clear();
                if (line is { } layer) _layer.Add(layer);
                break;
            case CommentKind.Z or CommentKind.Height:
                if (line is { } height) _layer.Add(height);
                break;
            case CommentKind.Role:
                _role = line;
                break;
            case CommentKind.ObjectStart or CommentKind.ObjectEnd:
                _object = line;
                break;
        }
    }

    private static CommentKind Kind(FileLine line)
    {
        var at = line.Start;
        while (at < line.End && line.Text[at] <= ' ') at++;
        return at < line.End && line.Text[at] == ';' ? CommentReader.Read(line.Text, at, line.End).Kind : CommentKind.None;
    }
}
