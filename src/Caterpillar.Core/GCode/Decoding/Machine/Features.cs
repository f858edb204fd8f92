namespace Caterpillar.GCode;

/// <summary>Features in which flavors differ, in the order of the report.</summary>
internal enum Feature
{
    Lines,
    CrLf,
    M82,
    M83,
    G90,
    G91,
    G92E,
    G92Xyz,
    G92All,
    G20,
    G21,
    NumberWords,
    Checksums,
    ParenComments,
    SemicolonComments,
    LowerCase,
    NoSpace,
    Exponents,
    MacrosIgnored,
    ModalLines,
    M200,
    FirmwareRetraction,
    MultiG,
    BlockDelete,
}

/// <summary>Counts lines with features in which flavors differ.</summary>
internal sealed class Features
{
    private static readonly string[] Names =
    [
        "lines", "crlf", "m82", "m83", "g90", "g91", "g92_e", "g92_xyz", "g92_all", "g20", "g21", "n_words", "checksums", "paren_comments",
        "semicolon_comments", "lower_case", "no_space", "exponents", "macros_ignored", "modal_lines", "m200", "g10", "multi_g", "block_delete",
    ];

    private readonly int[] _counts = new int[Names.Length];

    public void Add(Feature feature, int count = 1) => _counts[(int)feature] += count;

    public void Count(ParsedLine line)
    {
        if (line.NumberWordAt >= 0) Add(Feature.NumberWords);
        if (line.ChecksumAt >= 0) Add(Feature.Checksums);
        if (line.ParenStart >= 0) Add(Feature.ParenComments);
        if (line.CommentStart >= 0) Add(Feature.SemicolonComments);
        if (line.LowerCase) Add(Feature.LowerCase);
        if (line.NoSpace) Add(Feature.NoSpace);
        if (line.Exponent) Add(Feature.Exponents);
        if (line.BlockDelete) Add(Feature.BlockDelete);
        if (line.Shape == LineShape.Macro) Add(Feature.MacrosIgnored);
    }

    /// <summary>The counts that are not zero, in a fixed order.</summary>
    public IReadOnlyList<KeyValuePair<string, int>> ToList()
        => Names.Select((name, i) => new KeyValuePair<string, int>(name, _counts[i])).Where(p => p.Value > 0).ToArray();
}
