namespace Caterpillar.GCode;

/// <summary>Counts lines with features in which flavors differ.</summary>
internal sealed class Features
{
    public int Lines;
    public int CrLf;
    public int M82;
    public int M83;
    public int G90;
    public int G91;
    public int G92E;
    public int G92Xyz;
    public int G92All;
    public int G20;
    public int G21;
    public int NumberWords;
    public int Checksums;
    public int ParenComments;
    public int SemicolonComments;
    public int LowerCase;
    public int NoSpace;
    public int Exponents;
    public int MacrosIgnored;
    public int ModalLines;
    public int M200;
    public int FirmwareRetraction;
    public int MultiG;
    public int BlockDelete;

    public void Count(ParsedLine line)
    {
        if (line.NumberWordAt >= 0) NumberWords++;
        if (line.ChecksumAt >= 0) Checksums++;
        if (line.ParenStart >= 0) ParenComments++;
        if (line.CommentStart >= 0) SemicolonComments++;
        if (line.LowerCase) LowerCase++;
        if (line.NoSpace) NoSpace++;
        if (line.Exponent) Exponents++;
        if (line.BlockDelete) BlockDelete++;
        if (line.Shape == LineShape.Macro) MacrosIgnored++;
    }

    /// <summary>The counts that are not zero, in a fixed order.</summary>
    public IReadOnlyList<KeyValuePair<string, int>> ToList()
    {
        var list = new List<KeyValuePair<string, int>>();
        void Add(string name, int count)
        {
            if (count > 0) list.Add(new KeyValuePair<string, int>(name, count));
        }
        Add("lines", Lines);
        Add("crlf", CrLf);
        Add("m82", M82);
        Add("m83", M83);
        Add("g90", G90);
        Add("g91", G91);
        Add("g92_e", G92E);
        Add("g92_xyz", G92Xyz);
        Add("g92_all", G92All);
        Add("g20", G20);
        Add("g21", G21);
        Add("n_words", NumberWords);
        Add("checksums", Checksums);
        Add("paren_comments", ParenComments);
        Add("semicolon_comments", SemicolonComments);
        Add("lower_case", LowerCase);
        Add("no_space", NoSpace);
        Add("exponents", Exponents);
        Add("macros_ignored", MacrosIgnored);
        Add("modal_lines", ModalLines);
        Add("m200", M200);
        Add("g10", FirmwareRetraction);
        Add("multi_g", MultiG);
        Add("block_delete", BlockDelete);
        return list;
    }
}
