namespace Caterpillar.GCode;

/// <summary>Holds comments until it is decided whether the moves after them stay.</summary>
internal sealed class CommentBuffer(SpliceContext context)
{
    private const int LongestSetting = 100;
    private readonly List<FileLine> _lines = [];
    private readonly CutComments _cut = new();

    /// <summary>True if no comment waits.</summary>
    public bool IsEmpty => _lines.Count == 0 && _cut.IsEmpty;

    public void Add(FileLine line) => _lines.Add(line);

    /// <summary>Writes the comments, because the moves after them stay.</summary>
    public void Keep()
    {
        foreach (var line in _lines)
        {
            if (!_cut.IsEmpty) _cut.Keep(line);
            if (!IsUnitSetting(line)) context.Text.Add(line);
        }
        _lines.Clear();
    }

    /// <summary>Cuts the comments with the moves after them, until a kept move needs them.</summary>
    public void Cut()
    {
        foreach (var line in _lines) _cut.Cut(line);
        _lines.Clear();
    }

    /// <summary>Writes the comments of cut moves that the following moves need.</summary>
    public void WriteCut()
    {
        if (_cut.IsEmpty) return;
        foreach (var line in _lines) _cut.Keep(line);
        foreach (var line in _cut.Take())
        {
            var bytes = TextEncoding.Copy(line.Text, line.Start, line.End);
            context.Text.AddOwn(bytes, bytes.Length);
        }
    }

    // A setting that says in which unit E is changes with the unit.
    private bool IsUnitSetting(FileLine line)
    {
        if (context.Target is not { ChangesUnit: true } target || line.End - line.Start > LongestSetting) return false;
        var text = TextEncoding.Decode(line.Text, line.Start, line.End);
        if (text.IndexOf("use_volumetric_e = ", StringComparison.Ordinal) < 0) return false;
        var own = TextEncoding.Encode("; use_volumetric_e = " + (target.IsVolumetric ? "1" : "0"));
        context.Text.AddOwn(own, own.Length);
        return true;
    }
}
