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
        var parts = new List<(string Model, List<string> Values)>();
        foreach (var text in arguments.GetValue(_for) ?? [])
        {
            // The name may hold a colon, keys hold none.
            var equals = text.IndexOf('=');
            var colon = equals < 0 ? -1 : text.LastIndexOf(':', equals);
            if (colon < 1) throw CliException.Usage($"--for needs MODEL:KEY=VALUE, not \"{text}\".");
            var model = text[..colon];
            var values = Values(text[(colon + 1)..]);
            var with = session.ValueOrFail(setup.With(values), ExitCode.Usage);
            if (with.Printer != setup.Printer || with.Material != setup.Material || !with.ToolMaterials.Equals(setup.ToolMaterials))
                throw CliException.Usage($"--for {text}: only print settings can differ between models. Use --set for printer and material.");
            parts.Add((model, values));
        }
        return new ModelSettings(setup, parts);
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
internal sealed class ModelSettings(PrintSetup setup, IReadOnlyList<(string Model, List<string> Values)> own)
{
    /// <summary>What a project says of its models, and then the options.</summary>
    /// <exception cref="CliException">A model is not found.</exception>
    public IReadOnlyList<PrintSettings> For(IReadOnlyList<NamedMesh> models, IReadOnlyList<string> files, Session session)
    {
        var settings = session.ValueOrFail(ProjectModels.Settings(models, setup)).ToArray();
        foreach (var (name, values) in own)
        {
            var found = false;
            for (var i = 0; i < settings.Length; i++)
            {
                if (name != models[i].Name && name != files[i] && name != Path.GetFileName(files[i])) continue;
                settings[i] = session.ValueOrFail((setup with { Settings = settings[i] }).With(values)).Settings;
                found = true;
            }
            if (found) continue;
            var names = string.Join(", ", files.Concat(models.Select(m => m.Name)).Distinct().Take(10));
            throw CliException.Usage($"--for: model {name} not found. Models: {names}.");
        }
        return settings;
    }
}
