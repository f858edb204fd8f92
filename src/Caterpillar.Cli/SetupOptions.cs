using System.Collections.Generic;
using System.CommandLine;
using System.CommandLine.Completions;
using System.Linq;
using Caterpillar.Machines;

namespace Caterpillar.Cli;

/// <summary>The options that choose printer, material and settings; for every verb that needs them.</summary>
internal sealed class SetupOptions
{
    public Option<string> Printer { get; } = new("--printer", "-p") { Description = "Printer profile: a name (see \"caterpillar printers\") or a JSON file.",
        HelpName = "NAME|FILE", DefaultValueFactory = _ => "generic" };

    public Option<string?> Material { get; } = new("--material", "-m") { Description = "Material profile; the printer's default if omitted.",
        HelpName = "NAME|FILE" };

    public Option<string?> Settings { get; } = new("--settings", "-s") { Description = "Print settings; the printer's default if omitted.",
        HelpName = "NAME|FILE" };

    public Option<string[]> Set { get; } = new("--set") { Description = "Override any key of the three profiles, for example layer_height_mm=0.3.",
        HelpName = "KEY=VALUE" };

    public void AddTo(Verb verb)
    {
        Printer.CompletionSources.Add(_ => new ProfileLibrary().PrinterNames.Select(n => new CompletionItem(n)));
        Material.CompletionSources.Add(_ => new ProfileLibrary().MaterialNames.Select(n => new CompletionItem(n)));
        Settings.CompletionSources.Add(_ => new ProfileLibrary().SettingsNames.Select(n => new CompletionItem(n)));
        Set.CompletionSources.Add(_ => ProfileKeys.Printer.Concat(ProfileKeys.Material).Concat(ProfileKeys.Settings)
            .Select(k => new CompletionItem(k.Name + "=")));
        verb.Options.Add(Printer);
        verb.Options.Add(Material);
        verb.Options.Add(Settings);
        verb.Options.Add(Set);
    }

    /// <summary>True if a printer was named, and not just the default one.</summary>
    public bool IsGiven(ParseResult arguments) => arguments.GetResult(Printer) is { Implicit: false };

    /// <summary>The options as they were given, for another verb.</summary>
    public IEnumerable<string> Given(ParseResult arguments)
    {
        foreach (var option in new Option[] { Printer, Material, Settings, Set })
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
