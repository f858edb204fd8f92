namespace Caterpillar.Slicing;

/// <summary>Heights in a sentence: runs of layers that follow each other as ranges.</summary>
internal static class HeightRanges
{
    private const int MaxRanges = 6;

    /// <summary>For example <c>37 layers (z 2.1 to 9.3 and 12.1 mm)</c>; <paramref name="chosen"/> are ascending numbers of sections.</summary>
    public static string Of(IReadOnlyList<Section> sections, IReadOnlyList<int> chosen)
    {
        var ranges = new List<string>();
        for (int from = 0, to; from < chosen.Count; from = to)
        {
            for (to = from + 1; to < chosen.Count && chosen[to] == chosen[to - 1] + 1; to++)
            {
            }
            var first = Z(sections, chosen[from]);
            ranges.Add(to - from == 1 ? first : $"{first} to {Z(sections, chosen[to - 1])}");
        }
        var text = new StringBuilder(NumberFormatter.Format(chosen.Count)).Append(chosen.Count == 1 ? " layer (z " : " layers (z ");
        var shown = ranges.Count <= MaxRanges ? ranges.Count : MaxRanges - 1;
        for (var i = 0; i < shown; i++) text.Append(i == 0 ? "" : i == ranges.Count - 1 ? " and " : ", ").Append(ranges[i]);
        if (shown < ranges.Count) text.Append(" and ").Append(NumberFormatter.Format(ranges.Count - shown)).Append(" more ranges");
        return text.Append(" mm)").ToString();
    }

    private static string Z(IReadOnlyList<Section> sections, int number) => NumberFormatter.Format(sections[number].Z, 2);
}
