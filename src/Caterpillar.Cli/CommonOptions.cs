using System.CommandLine;
using System.Linq;
using Caterpillar.Dialects;
using Caterpillar.Machines;

namespace Caterpillar.Cli;

/// <summary>Options that several verbs have.</summary>
internal static class CommonOptions
{
    public static Option<int> Threads()
    {
        var option = new Option<int>("--threads") { Description = "Largest number of threads; all cores without it. The result is the same with any.",
            HelpName = "N" };
        option.Validators.Add(result =>
        {
            if (result.Tokens.Count == 1 && int.TryParse(result.Tokens[0].Value, out var threads) && threads < 1) result.AddError("--threads needs 1 or more.");
        });
        return option;
    }

    public static Option<string?> Dialect()
        => new("--dialect") { Description = "The firmware whose rules hold; detected from the file without it.", HelpName = "NAME" };

    /// <exception cref="CliException">There is no such dialect.</exception>
    public static DialectRules? DialectOf(string? name)
    {
        if (name is null) return null;
        return DialectTable.Find(name) ?? throw new CliException(
            ExitCode.Usage, $"There is no dialect \"{name}\"; there are " + string.Join(", ", DialectTable.All.Select(d => d.Name)) + ".");
    }
}
