namespace Caterpillar.GCode;

/// <summary>Finds the G-code flavor of a file from slicer comments and from commands that only one firmware has.</summary>
internal static class FlavorDetector
{
    public const string NotStated = "The file does not state its G-code flavor.";

    private const int Head = 96 * 1024;
    private const int Tail = 96 * 1024;
    private const int MaxHead = 8 * 1024 * 1024;

    private static readonly Lazy<string[][]> Signs = new(() => EmbeddedText.Rows("comments/FlavorSigns.tsv"));

    public static Detection Detect(IReadOnlyList<GCodeChunk> chunks, ExtrusionAxis axis)
    {
        var evidence = new List<string>();
        var text = Text(chunks);
        string? name = null;
        if (text.IndexOf("BambuStudio", StringComparison.Ordinal) is >= 0 and < 2000)
        {
            evidence.Add("The header names BambuStudio.");
            name = "bambu";
        }
        name ??= Declared(text, evidence) ?? ByCommand(text, evidence) ?? BySlicerFlavor(text, evidence);
        if (name is null && axis == ExtrusionAxis.Switched)
        {
            evidence.Add("M101 and M103 switch the extruder, and the file has no E values.");
            name = "bfb";
        }
        if (name is null && (axis == ExtrusionAxis.A || axis == ExtrusionAxis.Both || axis == ExtrusionAxis.B))
        {
            var sailfish = text.IndexOf("\nM126", StringComparison.Ordinal) >= 0 || text.IndexOf("\nG162", StringComparison.Ordinal) >= 0
                || axis != ExtrusionAxis.A;
            evidence.Add("The " + axis.Name + " axis extrudes.");
            name = sailfish ? "sailfish" : "cnc";
        }
        if (name is null && axis == ExtrusionAxis.None
            && (text.IndexOf("\nM3 ", StringComparison.Ordinal) >= 0 || text.IndexOf("\nM5", StringComparison.Ordinal) >= 0))
        {
            evidence.Add("The file has no extrusion, and M3 or M5 switches a spindle.");
            name = "grbl";
        }
        if (name is null) return new Detection(FlavorTable.Marlin2, [NotStated], true);
        return new Detection(FlavorTable.Find(name)!, evidence, false);
    }

    /// <summary>True if comments state the flavor without stronger evidence for another one. A conversion changes these comments.</summary>
    public static bool IsStated(IReadOnlyList<GCodeChunk> chunks)
    {
        var text = Text(chunks);
        var evidence = new List<string>();
        return Declared(text, evidence) is not null || (ByCommand(text, evidence) is null && BySlicerFlavor(text, evidence) is not null);
    }

    // What SetupFormat writes into the header.
    private static string? Declared(string text, List<string> evidence)
    {
        const string Mark = "; Flavor ";
        var at = text.IndexOf(Mark, 0, Math.Min(text.Length, 2000), StringComparison.Ordinal);
        if (at < 0 || (at > 0 && text[at - 1] is not ('\n' or '\r'))) return null;
        var end = at + Mark.Length;
        while (end < text.Length && text[end] > ' ') end++;
        var name = text.Substring(at + Mark.Length, end - at - Mark.Length);
        if (FlavorTable.Find(name) is null) return null;
        evidence.Add("The header states the flavor " + name + ".");
        return name;
    }

    /// <summary>The flavor for a slicer's flavor name, or null. PrusaSlicer's "marlin" is Marlin 1.</summary>
    public static string? OfSlicerFlavor(string flavor)
        => flavor.Trim().Equals("marlin", StringComparison.OrdinalIgnoreCase) ? FlavorTable.Marlin1.Name : FlavorTable.Find(flavor)?.Name;

    private static string? BySlicerFlavor(string text, List<string> evidence)
    {
        foreach (var key in new[] { ";FLAVOR:", "; gcode_flavor = ", "gcode_flavor = ", "machine_gcode_flavor = " })
        {
            var at = text.IndexOf(key, StringComparison.Ordinal);
            if (at < 0) continue;
            var end = at + key.Length;
            while (end < text.Length && text[end] != '\n' && text[end] != '\r') end++;
            var flavor = text.Substring(at + key.Length, end - at - key.Length).Trim();
            var plain = flavor.ToLowerInvariant();
            // Cura has one name for Marlin 1 and 2.
            if (plain == "marlin" && key[1] == 'F') plain = "marlin2";
            if (OfSlicerFlavor(plain) is not { } found) continue;
            evidence.Add("A comment states " + text.Substring(at, end - at).Trim());
            return found;
        }
        return null;
    }

    private static string? ByCommand(string text, List<string> evidence)
    {
        foreach (var sign in Signs.Value)
        {
            if (text.IndexOf("\n" + sign[0], StringComparison.Ordinal) < 0 && !text.StartsWith(sign[0], StringComparison.Ordinal)) continue;
            evidence.Add("The file contains " + sign[2] + ".");
            return sign[1];
        }
        return null;
    }

    // The beginning and the end of the file; CR as LF.
    private static string Text(IReadOnlyList<GCodeChunk> chunks)
    {
        if (chunks.Count == 0) return "";
        var text = new System.Text.StringBuilder();
        var (head, headEnd) = Beginning(chunks, text);
        text.Append('\n');
        var from = chunks.Count;
        for (var rest = Tail; from > 0 && rest > 0; from--) rest -= chunks[from - 1].Length;
        var left = Tail;
        for (var i = chunks.Count - 1; i > from; i--) left -= chunks[i].Length;
        for (var i = Math.Max(from, head); i < chunks.Count; i++)
        {
            var start = Math.Max(chunks[i].Start, i == from ? chunks[i].End - left : chunks[i].Start);
            text.Append(TextEncoding.Decode(chunks[i].Text, i == head ? Math.Max(start, headEnd) : start, chunks[i].End));
        }
        return text.Replace('\r', '\n').ToString();
    }

    // Adds the beginning without its thumbnails, which may be larger than all that is searched; returns where it ends.
    private static (int Chunk, int End) Beginning(IReadOnlyList<GCodeChunk> chunks, System.Text.StringBuilder text)
    {
        var inThumbnail = false;
        var seen = 0;
        for (var i = 0; ; i++)
        {
            var chunk = chunks[i];
            var at = chunk.Start;
            while (at < chunk.End && text.Length < Head)
            {
                var end = Math.Min(LineEnds.Next(chunk.Text, at, chunk.End), at + Head);
                var edge = chunk.Text[at] == ';' ? ThumbnailEdge(TextEncoding.Decode(chunk.Text, at, Math.Min(end, at + 60))) : 0;
                if (edge != 0) inThumbnail = edge > 0;
                else if (!inThumbnail) text.Append(TextEncoding.Decode(chunk.Text, at, end));
                at = end;
            }
            seen += chunk.Length;
            if (text.Length >= Head || seen > MaxHead || i + 1 == chunks.Count) return (i, at);
        }
    }

    // 1 at the beginning of a thumbnail, -1 at its end.
    private static int ThumbnailEdge(string line)
    {
        if (!line.StartsWith("; thumbnail", StringComparison.Ordinal)) return 0;
        if (line.IndexOf(" begin ", StringComparison.Ordinal) > 0) return 1;
        return line.TrimEnd().EndsWith(" end", StringComparison.Ordinal) ? -1 : 0;
    }
}

/// <summary>The flavor of a file, the evidence, and whether it is only the default.</summary>
internal readonly record struct Detection(FlavorRules Flavor, IReadOnlyList<string> Evidence, bool IsDefault);
