namespace Caterpillar.Slicing;

/// <summary>
/// Finds layers that a broken mesh has lost. A layer with closed gaps or omitted contours is compared with the nearest intact layers below and above: with
/// the smaller of the two, or with the only one. It is lost if its area is smaller by more than the given share, and if the missing length of its
/// contours can enclose that area (length² / 2π, a half circle). Layers of closed meshes are never checked, because they may grow and shrink freely.
/// </summary>
internal static class LostLayers
{
    /// <summary>A text with the layers, or null if there are none.</summary>
    public static string? Find(IReadOnlyList<Section> sections, double maxLossPercent, CancellationToken cancel)
    {
        if (maxLossPercent >= 100) return null;
        var share = maxLossPercent / 100;
        var lost = new List<int>();
        var (worst, worstPart) = (-1, double.PositiveInfinity);
        for (int from = 0, to; from < sections.Count; from = to)
        {
            to = from + 1;
            if (!IsBroken(sections[from])) continue;
            while (to < sections.Count && IsBroken(sections[to])) to++;
            cancel.ThrowIfCancellationRequested();
            var below = from > 0 ? Area(sections[from - 1]) : double.PositiveInfinity;
            var expected = Math.Min(below, to < sections.Count ? Area(sections[to]) : double.PositiveInfinity);
            if (!(expected > 0) || double.IsInfinity(expected)) continue;
            for (var i = from; i < to; i++)
            {
                var missing = Missing(sections[i]);
                if (missing * missing / (2 * Math.PI) < share * expected) continue;
                var part = Area(sections[i]) / expected;
                if (part >= 1 - share) continue;
                lost.Add(i);
                if (part < worstPart) (worst, worstPart) = (i, part);
            }
        }
        if (lost.Count == 0) return null;
        var limit = NumberFormatter.Format(maxLossPercent, 2);
        var left = NumberFormatter.Format(100 * worstPart, 1);
        return $"More than {limit} % of the area is missing on {HeightRanges.Of(sections, lost)} because contours do not close. "
            + $"At z {NumberFormatter.Format(sections[worst].Z, 2)} mm, {left} % of the area of the next intact layer is left. "
            + "Repair the model, close wider gaps (slice_gap_closing_mm), allow the loss (max_area_loss_percent=100) "
            + "or print open surfaces as single walls (open_contours=walls).";
    }

    private static bool IsBroken(Section section) => section.OpenLines.Count > 0 || section.Gaps.Length > 0;

    private static double Area(Section section) => ContourMeasure.NonZero(section.Loops).Area;

    private static double Missing(Section section) => section.OpenLines.Aggregate(section.Gaps.Length, (sum, line) => sum + line.Length);
}
