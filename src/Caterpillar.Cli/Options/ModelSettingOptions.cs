namespace Caterpillar.Cli;

/// <summary>Settings for one of several models: <c>--for lid.stl:wall_count=3,infill_density_percent=50</c>.</summary>
internal sealed class ModelSettingOptions
{
    private readonly Described<string[]> _for = new("--for",
        "Settings for one model. MODEL is its file or its name in the file, as in lid.stl:wall_count=3. With model_type=modifier: settings inside its volume. "
            + "Repeatable.", "MODEL:KEY=VALUE,...");

    public Option[] All => [_for];

    /// <exception cref="CliException">A value is wrong, or not a print setting.</exception>
    public ModelSettings Resolve(ParseResult arguments, PrintSetup setup, Session session)
    {
        var parts = new List<(string Model, PrintSettings Settings)>();
        foreach (var text in arguments.GetValue(_for) ?? [])
        {
            // The name may hold a colon, keys hold none.
            var equals = text.IndexOf('=');
            var colon = equals < 0 ? -1 : text.LastIndexOf(':', equals);
            if (colon < 1) throw new CliException(ExitCode.Usage, $"--for needs MODEL:KEY=VALUE, not \"{text}\".");
            var model = text[..colon];
            var known = parts.FindIndex(p => p.Model == model);
            var before = known < 0 ? setup : setup with { Settings = parts[known].Settings };
            var with = session.ValueOrFail(before.With(Values(text[(colon + 1)..])), ExitCode.Usage);
            if (with.Printer != setup.Printer || with.Material != setup.Material || !with.ToolMaterials.Equals(setup.ToolMaterials))
                throw new CliException(ExitCode.Usage, $"--for {text}: only print settings can differ between models. Use --set for printer and material.");
            if (known < 0) parts.Add((model, with.Settings));
            else parts[known] = (model, with.Settings);
        }
        return new ModelSettings(setup.Settings, parts);
    }

    // A comma is part of a value where no KEY= follows.
    private static List<string> Values(string text)
    {
        var values = new List<string>();
        foreach (var part in text.Split(','))
        {
            if (part.Contains('=') || values.Count == 0) values.Add(part);
            else values[^1] += "," + part;
        }
        return values;
    }
}

/// <summary>The settings of each model.</summary>
internal sealed class ModelSettings(PrintSettings common, IReadOnlyList<(string Model, PrintSettings Settings)> own)
{
    /// <exception cref="CliException">A model is not found.</exception>
    public IReadOnlyList<PrintSettings> For(IReadOnlyList<NamedMesh> models, IReadOnlyList<string> files)
    {
        var settings = Enumerable.Repeat(common, models.Count).ToArray();
        foreach (var (name, value) in own)
        {
            var found = false;
            for (var i = 0; i < settings.Length; i++)
            {
                if (name != models[i].Name && name != files[i] && name != Path.GetFileName(files[i])) continue;
                settings[i] = value;
                found = true;
            }
            if (found) continue;
            var names = string.Join(", ", files.Concat(models.Select(m => m.Name)).Distinct().Take(10));
            throw new CliException(ExitCode.Usage, $"--for: model {name} not found. Models: {names}.");
        }
        return settings;
    }
}
