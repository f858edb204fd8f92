using System.CommandLine;

namespace Caterpillar.Cli;

/// <summary>Options that several verbs have.</summary>
internal static class CommonOptions
{
    public static Option<int> Threads()
    {
        var option = new Option<int>("--threads") { Description = "Largest number of threads; all cores without it. The result is the same with any.", HelpName = "N" };
        option.Validators.Add(result =>
        {
            if (result.Tokens.Count == 1 && int.TryParse(result.Tokens[0].Value, out var threads) && threads < 1) result.AddError("--threads needs 1 or more.");
        });
        return option;
    }
}
