using System.CommandLine;
using System.CommandLine.Completions;
using System.Linq;
using Caterpillar.Dialects;
using Caterpillar.Expressions;

namespace Caterpillar.Cli;

/// <summary>Options shared by several verbs.</summary>
internal static class CommonOptions
{
    public static Option<int> Threads()
    {
        var option = new Option<int>("--threads") { Description = "Maximum number of threads; all cores by default. The result does not depend on it.",
            HelpName = "N" };
        option.Validators.Add(result =>
        {
            if (result.Tokens.Count == 1 && int.TryParse(result.Tokens[0].Value, out var threads) && threads < 1) result.AddError("--threads needs 1 or more.");
        });
        return option;
    }

    public static Option<string?> Dialect()
        => WithDialects(new("--dialect") { Description = "Firmware whose rules apply; detected from the file by default.", HelpName = "NAME" });

    /// <summary>Shells complete the names of dialects.</summary>
    public static Option<string?> WithDialects(Option<string?> option)
    {
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
