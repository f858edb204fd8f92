namespace Caterpillar.GCode;

/// <summary>Outlines of objects in EXCLUDE_OBJECT_DEFINE after an edit that moves or changes the objects.</summary>
internal sealed class OutlineFigures
{
    public const string Command = "EXCLUDE_OBJECT_DEFINE";
    private static readonly Regex Name = new(@"\sNAME=('[^']*'|""[^""]*""|\S+)", RegexOptions.CultureInvariant | RegexOptions.IgnoreCase);
    private static readonly Regex Place = new(@"\s+(?:CENTER|POLYGON)=\S+", RegexOptions.CultureInvariant | RegexOptions.IgnoreCase);
    private readonly Dictionary<string, IReadOnlyList<Vec3>> _changed = new(StringComparer.OrdinalIgnoreCase);

    public OutlineFigures(DecodedGCode decoding, Toolpath edited)
    {
        if (ReferenceEquals(decoding.Toolpath, edited) || !decoding.Ignored.ContainsKey(Command)) return;
        var before = ObjectOutlines.Of(decoding.Toolpath).ToDictionary(o => o.Name, o => o.Outline, StringComparer.Ordinal);
        foreach (var (name, outline) in ObjectOutlines.Of(edited))
        {
            if (before.TryGetValue(name, out var old) && outline.Count > 0 && !outline.SequenceEqual(old)) _changed[name] = outline;
        }
    }

    /// <summary>True if an outline has changed.</summary>
    public bool IsActive => _changed.Count > 0;

    /// <summary>The line with the outline after the edit.</summary>
    public FileLine Image(FileLine line)
    {
        if (!IsActive || line.End - line.Start <= Command.Length || line.Text[line.Start] is not ((byte)'E' or (byte)'e')) return line;
        var text = TextEncoding.Decode(line.Text, line.Start, line.End);
        if (!text.StartsWith(Command, StringComparison.OrdinalIgnoreCase) || !Name.Match(text).Success) return line;
        return _changed.TryGetValue(Name.Match(text).Groups[1].Value.Trim('\'', '"'), out var outline)
            ? line.WithText(TextEncoding.Encode(Place.Replace(text, "") + ObjectLabels.Place(outline))) : line;
    }
}
