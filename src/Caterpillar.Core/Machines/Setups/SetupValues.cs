namespace Caterpillar.Machines;

/// <summary>Applies <c>key=value</c> to a setup.</summary>
internal static class SetupValues
{
    public static Result<PrintSetup> Apply(PrintSetup setup, IEnumerable<string> values) => Apply(setup, values.Select(v => (v, new SourceLocation())));

    /// <summary>Applies values from places, which messages name.</summary>
    public static Result<PrintSetup> Apply(PrintSetup setup, IEnumerable<(string Entry, SourceLocation Place)> values)
    {
        var diagnostics = new List<Diagnostic>();
        foreach (var (entry, source) in values)
        {
            var at = entry.IndexOfAny(['=']);
            var key = (at < 0 ? entry : entry.Substring(0, at)).Trim();
            var place = source with { Key = key };
            if (at < 0) diagnostics.Add(new Diagnostic(Severity.Error, "profile.no_value", $"\"{entry}\" is not of the form key=value.", place));
            else setup = One(setup, key, entry.Substring(at + 1), place, diagnostics);
        }
        return new Result<PrintSetup>(diagnostics.Any(d => d.Severity == Severity.Error) ? null : setup, diagnostics.Distinct().ToArray());
    }

    /// <summary>The values as text.</summary>
    /// <param name="setup">The setup.</param>
    /// <param name="asGiven">True to leave what follows from the nozzle open, so that it follows another nozzle.</param>
    public static IReadOnlyList<KeyValuePair<string, string>> Of(PrintSetup setup, bool asGiven = false)
    {
        var settings = asGiven ? setup.Settings.AsGiven : setup.Settings;
        return
        [
            .. Of(ProfileKinds.Settings, settings), .. Of(ProfileKinds.Printer, setup.Printer), .. Of(ProfileKinds.Material, setup.Material),
            .. setup.ToolMaterials.SelectMany((material, i) => Of(ProfileKinds.Material, material)
                .Select(v => new KeyValuePair<string, string>(OfTool(v.Key, i + 1), v.Value))),
        ];

        static IEnumerable<KeyValuePair<string, string>> Of<T>(ProfileKind<T> kind, T profile)
            where T : class
            => kind.Keys.Where(k => k.Name != "title").Select(k => new KeyValuePair<string, string>(k.Name, RawValues.Text(k.Get(profile))));
    }

    /// <summary>The key of the material of a tool: <c>nozzle_temperature_c[1]</c>.</summary>
    public static string OfTool(string key, int tool) => $"{key}[{NumberFormatter.Format(tool)}]";

    private static PrintSetup One(PrintSetup setup, string key, string text, SourceLocation place, List<Diagnostic> diagnostics)
    {
        var named = Regex.Match(key, @"^(.+)\[([0-9]{1,2})\]$");
        int? tool = named.Success ? int.Parse(named.Groups[2].Value, CultureInfo.InvariantCulture) : null;
        if (tool <= setup.ToolMaterials.Count && ProfileKinds.Material.Find(named.Groups[1].Value) is not null) key = named.Groups[1].Value;
        // All three have a title, which does not affect the print.
        if (key == "title")
        {
            diagnostics.Add(new Diagnostic(Severity.Error, "profile.unknown_key", "title does not affect a print. Change it in the profile.", place));
            return setup;
        }
        if (Changed(ProfileKinds.Settings, setup.Settings) is { } settings) return setup with { Settings = settings };
        if (ProfileKinds.Material.Find(key) is not null)
        {
            Material Own(Material old, int i) => tool is null || tool == i ? Changed(ProfileKinds.Material, old)! : old;
            return setup with { Material = Own(setup.Material, 0), ToolMaterials = new(setup.ToolMaterials.Select((m, i) => Own(m, i + 1))) };
        }
        if (Changed(ProfileKinds.Printer, setup.Printer) is { } printer) return setup with { Printer = printer };
        var known = ProfileKeys.All.Select(k => k.Name).Where(k => k != "title");
        diagnostics.Add(UnknownKey.Problem("printers, materials or settings", key, text, known, place));
        return setup;

        // The same profile where the value is wrong, and none where the key is not one of this kind.
        T? Changed<T>(ProfileKind<T> kind, T profile)
            where T : class
            => kind.Find(key) is { } found
                ? kind.Apply(profile, key, Parse(found, found.Get(profile), text), place, diagnostics)
                : null;
    }

    // Text of another kind is passed on as text, so that the message can show it.
    private static object Parse(ProfileKey key, object present, string text) => key.Format.Parse(text) ?? Percent(key, present, text.Trim()) ?? text;

    // Speeds, flows and accelerations take percents of what the profile says, and factors are percents themselves.
    private static object? Percent(ProfileKey key, object present, string text)
    {
        if (key.Kind != KeyKind.Number || !text.EndsWith("%", StringComparison.Ordinal)) return null;
        if (!NumberReader.TryParse(text.Substring(0, text.Length - 1).Trim(), out var percent)) return null;
        bool Ends(string ending) => key.Name.EndsWith(ending, StringComparison.Ordinal);
        if (Ends("_percent")) return percent;
        if (Ends("_mm_s") || Ends("_mm_s2") || Ends("_mm3_s")) return present is double speed ? percent / 100 * speed : null;
        return Ends("_ratio") ? percent / 100 : null;
    }
}
