namespace Caterpillar.Machines;

/// <summary>Makes profiles of ours from presets of another slicer.</summary>
internal sealed class SlicerImport(IReadOnlyList<SlicerPreset> presets, string name, Printer? like, string file, List<Diagnostic> problems)
{
    // How many values without an equal a message shows.
    private const int Shown = 400;

    private static readonly Lazy<HashSet<string>> Ignored = new(() => [.. EmbeddedText.Rows("names/SlicerIgnored.tsv").Skip(1).Select(r => r[0])]);
    private static readonly Lazy<ILookup<string, string[]>> Defaults = new(() => EmbeddedText.Rows("names/SlicerDefaults.tsv").Skip(1).ToLookup(r => r[0]));

    private readonly HashSet<string> _names = new(StringComparer.Ordinal);
    private readonly SortedDictionary<string, string> _lost = new(StringComparer.Ordinal);

    /// <summary>
    /// The profiles of one printer with its default material and settings, or of all presets. A printer, a material and settings that are no part of a
    /// printer come from presets without one.
    /// </summary>
    /// <param name="wanted">Name of the printer; null = all.</param>
    public ImportedProfiles? Run(string? wanted)
    {
        var (printers, materials, settings) = (new List<Printer>(), new List<Material>(), new List<PrintSettings>());
        var made = new Dictionary<SlicerPreset, string>();
        var machines = Of("printer").Where(p => wanted is null || p.Name == wanted).ToArray();
        if (wanted is not null && machines.Length == 0)
        {
            var names = Of("printer").Select(p => p.Name).ToArray();
            var near = Expressions.SpellingSuggestion.Nearest(wanted, names);
            problems.Add(new Diagnostic(Severity.Error, "import.no_printer", $"The file has no printer \"{wanted}\". "
                + (near is not null ? $"Did you mean \"{near}\"?" : $"It has: {string.Join(", ", names.Take(Shown))}."), new SourceLocation(file)));
            return null;
        }
        foreach (var machine in machines)
        {
            var print = machine.Kind.Length == 0 ? machine : Find("print", machine.First("default_print_profile"));
            var filament = machine.Kind.Length == 0 ? machine : Find("filament", machine.First("default_filament_profile"));
            Missing(machine, "default_print_profile", print);
            Missing(machine, "default_filament_profile", filament);
            var setup = Setup(machine, filament, print);
            var printer = setup.Printer with { Name = NameOf(machine, "printer"), Title = TitleOf(machine, "printer") };
            if (filament is not null) printer = printer with { DefaultMaterial = Once(filament, "filament", setup.Material, materials) };
            if (print is not null) printer = printer with { DefaultSettings = Once(print, "print", setup.Settings.AsGiven, settings) };
            printers.Add(printer);
        }
        foreach (var preset in presets.Where(p => wanted is null && !p.IsBase && p.Kind is "print" or "filament"))
        {
            if (preset.Kind == "print") Once(preset, "print", Setup(preset).Settings.AsGiven, settings);
            else Once(preset, "filament", Setup(preset).Material, materials);
        }
        ReportLost();
        if (printers.Count + materials.Count + settings.Count == 0)
        {
            const string None = "The file has no settings of a printer, a filament or a print.";
            problems.Add(new Diagnostic(Severity.Error, "import.empty", None, new SourceLocation(file)));
        }
        return new ImportedProfiles(printers, materials, settings);

        string Once<T>(SlicerPreset preset, string kind, T profile, List<T> all)
            where T : class
        {
            var key = preset with { Kind = kind };
            if (made.TryGetValue(key, out var known)) return known;
            var id = made[key] = NameOf(preset, kind);
            all.Add((T)(object)(profile switch
            {
                Material material => material with { Name = id, Title = TitleOf(preset, kind) },
                PrintSettings print => print with { Name = id, Title = TitleOf(preset, kind) },
                _ => profile,
            }));
            return id;
        }
    }

    /// <summary>The setup with the values of a model in a project.</summary>
    /// <param name="setup">The print.</param>
    /// <param name="values">Values of the model.</param>
    /// <param name="lost">Names without an equal here.</param>
    public static PrintSetup Own(PrintSetup setup, IReadOnlyDictionary<string, string> values, out IReadOnlyList<string> lost)
    {
        var problems = new List<Diagnostic>();
        var used = new HashSet<string>(StringComparer.Ordinal);
        var with = Apply(setup, SlicerPreset.SlicerOf(values), values, null, used, problems);
        lost = values.Keys.Where(k => !used.Contains(k) && !Ignored.Value.Contains(k)).ToArray();
        return setup with { Settings = with.Settings };
    }

    // The setup with all values that have an equal; their names are added to those that are used.
    private static PrintSetup Apply(PrintSetup setup, string slicer, IReadOnlyDictionary<string, string> values, SlicerTemplate? template, HashSet<string> used,
        List<Diagnostic> problems)
    {
        foreach (var names in SlicerName.All.Where(n => n.Slicer == slicer).GroupBy(n => n.Key))
        {
            var value = names.Select(n => n.Convert(values)).FirstOrDefault(v => v is not null);
            if (names.First().IsTemplate && template is not null && names.Any(n => values.ContainsKey(n.Name)))
            {
                value = string.Join("\n", names.SelectMany(n => template.Lines(n.Name, n.Key)));
                // Half a tool change is worse than the command alone.
                if (names.Key.Name == "tool_change_gcode" && template.HasLost) value = "";
            }
            if (value is null) continue;
            used.UnionWith(names.SelectMany(n => n.Names));
            var with = setup.With(names.Key.Name + "=" + value);
            if (with.Value is not null) setup = with.Value;
            else problems.AddRange(with.Diagnostics.Select(d => d with { Severity = Severity.Warning }));
        }
        return setup;
    }

    private IEnumerable<SlicerPreset> Of(string kind) => presets.Where(p => !p.IsBase && (p.Kind == kind || p.Kind.Length == 0));

    private SlicerPreset? Find(string kind, string name) => presets.FirstOrDefault(p => p.Kind == kind && p.Name == name);

    // Values that a file does not state are the defaults of its slicer.
    private PrintSetup Setup(params SlicerPreset?[] parts)
    {
        var values = new Dictionary<string, string>(StringComparer.Ordinal);
        foreach (var part in parts)
        {
            foreach (var pair in part?.Values ?? new Dictionary<string, string>()) values[pair.Key] = pair.Value;
        }
        var slicer = SlicerPreset.SlicerOf(values);
        var given = new HashSet<string>(values.Keys);
        foreach (var row in Defaults.Value[slicer].Where(r => !values.ContainsKey(r[1]))) values[row[1]] = row[2];
        var setup = new PrintSetup(like ?? new Printer(), new Material(), new PrintSettings());
        var used = new HashSet<string>(StringComparer.Ordinal);
        setup = Apply(setup, slicer, values, new SlicerTemplate(values, file, problems.Add), used, problems);
        foreach (var key in given.Where(k => !used.Contains(k) && !Ignored.Value.Contains(k)))
        {
            if (values[key].Split(',')[0].Trim('"') is not ("" or "0" or "0%" or "nil" or "none" or "disabled" or "100%" or "0x0")) _lost[key] = values[key];
        }
        var completed = Completed(setup.Printer);
        ReportMacros(completed, parts[0]!);
        return setup with { Printer = completed };
    }

    // Other slicers heat before and after start code that does not, and change tools themselves.
    private static Printer Completed(Printer printer)
    {
        bool Has(ValueList<string> lines, params string[] commands) => lines.Any(l => Array.IndexOf(commands, Command(l)) >= 0);
        string[] before = Has(printer.StartGCode, "M140", "M190") ? [] : ["{if bed_temperature_c > 0}", "M190 S{start_bed_temperature_c}", "{endif}"];
        string[] after = Has(printer.StartGCode, "M104", "M109") ? [] : ["M109 S{start_nozzle_temperature_c}"];
        var change = printer.ToolChangeGCode;
        var changes = change.Any(l => Command(l).StartsWith("T", StringComparison.Ordinal));
        if (!changes && change.Any(l => Command(l).Length > 0)) change = new([.. change, "T{tool}"]);
        return printer with { StartGCode = new([.. before, .. printer.StartGCode, .. after]), ToolChangeGCode = change };
    }

    private void Missing(SlicerPreset machine, string key, SlicerPreset? found)
    {
        if (found is not null || machine.First(key).Length == 0) return;
        problems.Add(new Diagnostic(Severity.Warning, "import.no_parent",
            $"{machine.Name}: {key} \"{machine.First(key)}\" not found. The printer has our defaults.", new SourceLocation(file)));
    }

    private void ReportMacros(Printer printer, SlicerPreset preset)
    {
        var known = Flavors.FlavorCommands.Of(printer.Flavor);
        var unknown = printer.StartGCode.Concat(printer.EndGCode).Concat(printer.LayerChangeGCode).Concat(printer.ToolChangeGCode)
            .Select(Bare).Where(l => l.Length > 0 && known.Find(l) is null).Select(Command).Distinct().ToArray();
        if (unknown.Length == 0) return;
        problems.Add(new Diagnostic(Severity.Warning, "import.macro", $"{string.Join(", ", unknown)}: not known what it does. Declare it in the key macros, "
            + $"such as {unknown[0]}=homes heats, or {unknown[0]}=harmless.", new SourceLocation(file, Key: TitleOf(preset, "printer"))));
    }

    private static string Command(string line) => Bare(line).Split(' ')[0].ToUpperInvariant();

    // A line without its comment and conditions, with any number for each value.
    private static string Bare(string line)
        => Regex.Replace(Regex.Replace(line.Split(';')[0], @"\{(if|elsif|else|endif)\b[^}]*\}", ""), @"\{[^}]*\}", "0").Trim();

    private void ReportLost()
    {
        if (_lost.Count == 0) return;
        var shown = _lost.Select(l => l.Value.Length < 40 ? l.Key + "=" + l.Value : l.Key).Take(Shown);
        var count = NumberFormatter.Format(_lost.Count) + (_lost.Count == 1 ? " setting has" : " settings have");
        problems.Add(new Diagnostic(Severity.Note, "import.no_equal", $"{count} no equal here: {string.Join(", ", shown)}.", new SourceLocation(file)));
    }

    private string TitleOf(SlicerPreset preset, string kind)
    {
        var title = preset.Name.Length > 0 ? preset.Name : preset.First(kind + "_settings_id");
        return title.Length > 0 ? title : name;
    }

    // Names of files without the signs that some systems or we ourselves give a meaning.
    private string NameOf(SlicerPreset preset, string kind)
    {
        var letters = TitleOf(preset, kind).ToLowerInvariant().Select(c => c is >= 'a' and <= 'z' or >= '0' and <= '9' ? c : ' ');
        var plain = string.Join("_", string.Concat(letters).Split([' '], StringSplitOptions.RemoveEmptyEntries));
        if (plain.Length == 0) plain = "imported";
        var unique = plain;
        for (var i = 2; !_names.Add(kind + " " + unique); i++) unique = plain + "_" + NumberFormatter.Format(i);
        return unique;
    }
}
