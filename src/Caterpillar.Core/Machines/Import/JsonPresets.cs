namespace Caterpillar.Machines;

/// <summary>
/// Reads presets of OrcaSlicer and Bambu Studio: a JSON file, what it inherits, and for a printer its default material and settings. These are looked for
/// beside the file, in the tree of its vendor (the folder beside <c>VENDOR.json</c>), and in the trees of other vendors next to it.
/// </summary>
internal sealed class JsonPresets(List<Diagnostic> problems)
{
    private const int MaxDepth = 50;

    public static List<SlicerPreset> Read(string text, string file, List<Diagnostic> problems)
    {
        var reader = new JsonPresets(problems);
        if (reader.Preset(text, file) is not { } preset) return [];
        var presets = new List<SlicerPreset> { preset };
        foreach (var key in new[] { "default_print_profile", "default_filament_profile" })
        {
            var name = preset.Kind == "printer" ? preset.First(key) : "";
            if (name.Length == 0) continue;
            if (Find(name, file) is not { } path) reader.Missing(file, $"The default \"{name}\"", Severity.Warning);
            else if (reader.Preset(File.ReadAllText(path), path) is { } other) presets.Add(other);
        }
        return presets;
    }

    private SlicerPreset? Preset(string text, string file)
    {
        if (Whole(text, file, 0) is not { } values) return null;
        var kind = values.TryGetValue("type", out var type) ? type switch { "machine" => "printer", "process" => "print", "filament" => type, _ => "" } : "";
        return new SlicerPreset(kind, values.TryGetValue("name", out var name) ? name : "", values, false);
    }

    private Dictionary<string, string>? Whole(string text, string file, int depth)
    {
        if (JsonFlat.Read(text, file, problems) is not { } entries) return null;
        var whole = new Dictionary<string, string>(StringComparer.Ordinal);
        if (entries.FirstOrDefault(e => e.Key == "inherits")?.Value is string { Length: > 0 } parent && depth < MaxDepth)
        {
            if (Find(parent, file) is { } path) whole = Whole(File.ReadAllText(path), path, depth + 1) ?? whole;
            else Missing(file, $"The inherited \"{parent}\"", Severity.Error);
        }
        foreach (var entry in entries) whole[entry.Key] = Text(entry.Key, entry.Value);
        return whole;
    }

    // Templates have one text for each extruder.
    private static string Text(string key, object? value) => value switch
    {
        IReadOnlyList<object> { Count: > 1 } list when key.EndsWith("gcode", StringComparison.Ordinal) => Text(key, list[0]),
        IReadOnlyList<object> list => string.Join(",", list.Select(i => Text(key, i))),
        double number => NumberFormatter.Shortest(number),
        bool flag => flag ? "1" : "0",
        _ => value as string ?? "",
    };

    private static string? Find(string name, string file)
    {
        var folder = Path.GetDirectoryName(Path.GetFullPath(file));
        if (folder is null || name.IndexOfAny(Path.GetInvalidFileNameChars()) >= 0) return null;
        var beside = Path.Combine(folder, name + ".json");
        if (File.Exists(beside)) return beside;
        var vendor = folder;
        while (vendor is not null && !File.Exists(vendor + ".json")) vendor = Path.GetDirectoryName(vendor);
        if (vendor is null) return null;
        return new[] { vendor, Path.GetDirectoryName(vendor)! }
            .SelectMany(f => Directory.GetFiles(f, name + ".json", SearchOption.AllDirectories).OrderBy(p => p, StringComparer.Ordinal)).FirstOrDefault();
    }

    private void Missing(string file, string what, Severity severity)
        => problems.Add(new Diagnostic(severity, "import.no_parent",
            $"{what} is neither beside the file nor in the folder of its vendor. Copy its JSON file there.", new SourceLocation(file)));
}
