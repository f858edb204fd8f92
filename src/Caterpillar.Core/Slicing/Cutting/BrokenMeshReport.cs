namespace Caterpillar.Slicing;

/// <summary>Describes the repairs and omissions of a broken mesh, with layers and sizes.</summary>
internal static class BrokenMeshReport
{
    /// <summary>The text, or null if there is nothing to report.</summary>
    public static string? Describe(RepairedMesh repaired, IReadOnlyList<Section> sections)
    {
        var sentences = new List<string>();
        var parts = MeshParts(repaired);
        if (parts.Count > 0) sentences.Add($"Repaired: {string.Join(", ", parts)}.");
        if (Gaps(sections) is { } gaps) sentences.Add(gaps);
        if (LeftOut(sections) is { } left) sentences.Add(left);
        return sentences.Count == 0 ? null : "The mesh is broken. " + string.Join(" ", sentences);
    }

    private static List<string> MeshParts(RepairedMesh repaired)
    {
        var parts = new List<string>();
        if (repaired.MovedVertices > 0)
            parts.Add($"{Count(repaired.MovedVertices, "vertex", "vertices")} moved by up to {Millimeters(repaired.FarthestMove, 3)} to join naked edges");
        if (repaired.DuplicateFaces > 0) parts.Add($"{Count(repaired.DuplicateFaces, "duplicate face", "duplicate faces")} removed");
        if (repaired.FlippedFaces > 0) parts.Add($"{Count(repaired.FlippedFaces, "inward-facing face", "inward-facing faces")} flipped");
        if (repaired.FlippedBodies > 0) parts.Add($"{Count(repaired.FlippedBodies, "inside-out body", "inside-out bodies")} flipped");
        if (repaired.Holes.Count > 0)
        {
            var box = Bounds.Empty;
            var width = 0.0;
            foreach (var hole in repaired.Holes)
            {
                box = box.Include(hole.Box);
                width = Math.Max(width, hole.Width);
            }
            var heights = $"z {NumberFormatter.Format(box.Min.Z, 2)} to {NumberFormatter.Format(box.Max.Z, 2)} mm";
            parts.Add($"{Count(repaired.Holes.Count, "hole", "holes")} filled ({heights}, up to {Millimeters(width, 2)} wide)");
        }
        if (repaired.LooseFaces > 0) parts.Add($"{Count(repaired.LooseFaces, "loose face", "loose faces")} removed at filled holes");
        return parts;
    }

    private static string? Gaps(IReadOnlyList<Section> sections)
    {
        var layers = new List<int>();
        var count = 0;
        double length = 0, widest = 0;
        for (var i = 0; i < sections.Count; i++)
        {
            var gaps = sections[i].Gaps;
            if (gaps.Count == 0) continue;
            layers.Add(i);
            count += gaps.Count;
            length += gaps.Length;
            widest = Math.Max(widest, gaps.Widest);
        }
        if (layers.Count == 0) return null;
        var sizes = $"{Millimeters(length, 2)} in total, the widest {Millimeters(widest, 2)}";
        return $"{Count(count, "gap", "gaps")} in contours closed on {HeightRanges.Of(sections, layers)}: {sizes}.";
    }

    private static string? LeftOut(IReadOnlyList<Section> sections)
    {
        var layers = new List<int>();
        var count = 0;
        var length = 0.0;
        for (var i = 0; i < sections.Count; i++)
        {
            if (sections[i].OpenLines.Count == 0) continue;
            layers.Add(i);
            count += sections[i].OpenLines.Count;
            foreach (var line in sections[i].OpenLines) length += line.Length;
        }
        if (layers.Count == 0) return null;
        var contours = Count(count, "open contour", "open contours");
        return $"{contours} left out on {HeightRanges.Of(sections, layers)}: {Millimeters(length, 1)} in total.";
    }

    private static string Count(int count, string one, string many) => $"{NumberFormatter.Format(count)} {(count == 1 ? one : many)}";

    private static string Millimeters(double value, int decimals) => $"{NumberFormatter.Format(value, decimals)} mm";
}
