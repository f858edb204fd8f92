using Caterpillar.Basics;
using Caterpillar.Geometry;

namespace Caterpillar.Slicing;

/// <summary>Says what was mended of a broken mesh, on which layers and by how much, and what is left out.</summary>
internal static class BrokenMeshReport
{
    /// <summary>The text, or null where there is nothing to say.</summary>
    public static string? Describe(MendedMesh mended, IReadOnlyList<Section> sections)
    {
        var sentences = new List<string>();
        var parts = MeshParts(mended);
        if (parts.Count > 0) sentences.Add($"Mended: {string.Join(", ", parts)}.");
        if (Gaps(sections) is { } gaps) sentences.Add(gaps);
        if (LeftOut(sections) is { } left) sentences.Add(left);
        return sentences.Count == 0 ? null : "The mesh is broken. " + string.Join(" ", sentences);
    }

    private static List<string> MeshParts(MendedMesh mended)
    {
        var parts = new List<string>();
        if (mended.MovedVertices > 0)
            parts.Add($"{Count(mended.MovedVertices, "vertex", "vertices")} moved by up to {Millimeters(mended.FarthestMove, 3)} to join rims");
        if (mended.DoubledFacets > 0) parts.Add($"{Count(mended.DoubledFacets, "doubled triangle", "doubled triangles")} taken once");
        if (mended.TurnedFacets > 0) parts.Add($"{Count(mended.TurnedFacets, "triangle", "triangles")} turned that faced inwards");
        if (mended.TurnedBodies > 0) parts.Add($"{Count(mended.TurnedBodies, "body that was", "bodies that were")} inside out turned");
        if (mended.Holes.Count > 0)
        {
            var box = Bounds.Empty;
            var width = 0.0;
            foreach (var hole in mended.Holes)
            {
                box = box.Include(hole.Box);
                width = Math.Max(width, hole.Width);
            }
            var heights = $"z {NumberFormatter.Format(box.Min.Z, 2)} to {NumberFormatter.Format(box.Max.Z, 2)} mm";
            parts.Add($"{Count(mended.Holes.Count, "hole", "holes")} filled ({heights}, the widest {Millimeters(width, 2)})");
        }
        if (mended.LooseFacets > 0) parts.Add($"{Count(mended.LooseFacets, "loose triangle", "loose triangles")} left out at filled holes");
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
        var sizes = $"{Millimeters(length, 2)} in all, the widest {Millimeters(widest, 2)}";
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
        var contours = Count(count, "contour that does not close", "contours that do not close");
        return $"Left out: {contours}, {Millimeters(length, 1)} in all, on {HeightRanges.Of(sections, layers)}.";
    }

    private static string Count(int count, string one, string many) => $"{NumberFormatter.Format(count)} {(count == 1 ? one : many)}";

    private static string Millimeters(double value, int decimals) => $"{NumberFormatter.Format(value, decimals)} mm";
}
