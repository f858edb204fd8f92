using System.CommandLine.Completions;
using Caterpillar.Dialects;
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

    public static Described<string?> Dialect() => Dialect("--dialect", "Firmware whose rules apply; detected from the file by default.", "NAME");

    /// <summary>An option for the name of a dialect, which shells complete.</summary>
    public static Described<string?> Dialect(string name, string description, string value)
    {
        var option = new Described<string?>(name, description, value);
        option.CompletionSources.Add(_ => DialectTable.All.Select(d => new CompletionItem(d.Name)));
        return option;
    }

    /// <exception cref="CliException">There is no such dialect.</exception>
    public static DialectRules? DialectOf(string? name)
    {
        if (name is null) return null;
        return DialectTable.Find(name) ?? throw new CliException(
            ExitCode.Usage, $"There is no dialect \"{name}\"; there are " + string.Join(", ", DialectTable.All.Select(d => d.Name)) + "."
                + SpellingSuggestion.Hint(name, DialectTable.All.Select(d => d.Name)));
    }
}
