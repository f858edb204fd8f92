using System.CommandLine.Completions;

namespace Caterpillar.Cli;

/// <summary>The options that choose printer, material and settings; for every verb that needs them.</summary>
internal sealed class SetupOptions
{
    public Described<string> Printer { get; } = new("--printer",
        "Printer profile: a name (see \"caterpillar printers\") or a JSON file.", "NAME|FILE", "-p") { DefaultValueFactory = _ => "generic" };

    public Described<string?> Material { get; } = new("--material", "Material profile; the printer's default if omitted.", "NAME|FILE", "-m");

    public Described<string?> Settings { get; } = new("--settings", "Print settings; the printer's default if omitted.", "NAME|FILE", "-s");

    public Described<string[]> Set { get; } = new("--set", "Override any key of the three profiles, for example layer_height_mm=0.3.", "KEY=VALUE");

    public SetupOptions()
    {
        Printer.CompletionSources.Add(_ => new ProfileLibrary().PrinterNames.Select(n => new CompletionItem(n)));
        Material.CompletionSources.Add(_ => new ProfileLibrary().MaterialNames.Select(n => new CompletionItem(n)));
        Settings.CompletionSources.Add(_ => new ProfileLibrary().SettingsNames.Select(n => new CompletionItem(n)));
        Set.CompletionSources.Add(_ => ProfileKeys.Printer.Concat(ProfileKeys.Material).Concat(ProfileKeys.Settings)
            .Select(k => new CompletionItem(k.Name + "=")));
    }

    public Option[] All => [Printer, Material, Settings, Set];

    /// <summary>True if a printer was named, and not just the default one.</summary>
    public bool IsGiven(ParseResult arguments) => arguments.GetResult(Printer) is { Implicit: false };

    /// <summary>The options as they were given, for another verb.</summary>
    public IEnumerable<string> Given(ParseResult arguments)
    {
        foreach (var option in All)
        {
            if (arguments.GetResult(option) is not { Implicit: false } given) continue;
            foreach (var token in given.Tokens)
            {
                yield return option.Name;
                yield return token.Value;
            }
        }
    }

    /// <summary>The requested setup; its problems are printed. Without a named printer, <paramref name="own"/> are the profiles named in the input.</summary>
    /// <exception cref="CliException">There is no such profile or key (wrong usage), or a profile is bad (bad input).</exception>
    public PrintSetup Resolve(ParseResult arguments, Session session, IReadOnlyList<string>? own = null)
    {
        var values = arguments.GetValue(Set) ?? [];
        if (own is null || IsGiven(arguments)) own = [];
        var printer = own.Count > 0 ? own[0] : arguments.GetValue(Printer)!;
        var material = arguments.GetValue(Material) ?? (own.Count > 1 ? own[1] : null);
        var settings = arguments.GetValue(Settings) ?? (own.Count > 2 ? own[2] : null);
        var plain = session.Profiles.Setup(printer, material, settings);
        if (plain.Diagnostics.Any(d => d.Code == "profile.not_found")) session.ValueOrFail(plain, ExitCode.Usage);
        if (values.Length == 0 || plain.Value is null) return session.ValueOrFail(plain);
        return session.ValueOrFail(session.Profiles.Setup(printer, material, settings, values), ExitCode.Usage);
    }
}
