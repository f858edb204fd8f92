using System.CommandLine.Completions;
using Caterpillar.Flavors;
using Caterpillar.Expressions;

namespace Caterpillar.Cli;

/// <summary>Options shared by several verbs.</summary>
internal static class CommonOptions
{
    public static Described<int> Threads()
    {
        var option = new Described<int>("--threads", "Maximum number of threads; all cores by default. The result does not depend on it.", "N");
        option.Validators.Add(result =>
        {
            if (result.Tokens.Count == 1 && int.TryParse(result.Tokens[0].Value, out var threads) && threads < 1) result.AddError("--threads needs 1 or more.");
        });
        return option;
    }

    public static Described<string?> Flavor() => Flavor("--flavor", "Firmware whose rules apply; detected from the file by default.", "NAME");

    /// <summary>An option for the name of a flavor, which shells complete.</summary>
    public static Described<string?> Flavor(string name, string description, string value)
    {
        var option = new Described<string?>(name, description, value);
        option.CompletionSources.Add(_ => FlavorTable.All.Select(d => new CompletionItem(d.Name)));
        return option;
    }

    /// <exception cref="CliException">There is no such flavor.</exception>
    public static FlavorRules? FlavorOf(string? name)
    {
        if (name is null) return null;
        return FlavorTable.Find(name) ?? throw new CliException(
            ExitCode.Usage, $"There is no flavor \"{name}\"; there are " + string.Join(", ", FlavorTable.All.Select(d => d.Name)) + "."
                + SpellingSuggestion.Hint(name, FlavorTable.All.Select(d => d.Name)));
    }
}
