namespace Caterpillar.Cli;

/// <summary>Writes what a shell runs to complete a command line. It calls this verb with the line, which the parser of the program completes.</summary>
internal sealed partial class CompletionsVerb : Verb
{
    private readonly Argument<string> _shell = new("SHELL") { Description = "Shell to write completions for." };

    private readonly Described<string?> _line = new("--line", "Write the completions of a command line up to the cursor.", "TEXT") { Hidden = true };

    public CompletionsVerb()
        : base("completions", "Write shell completions for commands, options and values.")
    {
        _shell.AcceptOnlyFromAmong("bash", "zsh", "fish", "powershell");
        Arguments.Add(_shell);
        Add(_line);
    }

    public override int Run(ParseResult arguments, Session session)
    {
        var shell = arguments.GetValue(_shell)!;
        if (arguments.GetValue(_line) is { } line) session.WriteText("-", text => Complete(arguments.RootCommandResult.Command, line, shell, text));
        else session.WriteText("-", text => text.Write(EmbeddedText.Read("usage/completions." + shell, typeof(CompletionsVerb))));
        return ExitCode.Done;
    }

    // A line for each completion: the word, and but for bash its description.
    private static void Complete(Command root, string line, string shell, TextWriter text)
    {
        var word = line[(line.LastIndexOf(' ') + 1)..];
        foreach (var item in root.Parse(line).GetCompletions(line.Length))
        {
            var value = item.InsertText ?? item.Label;
            if (!value.StartsWith(word, StringComparison.OrdinalIgnoreCase) || (word.Length == 0 && value[0] is '-' or '/')) continue;
            var help = item.Detail is { Length: > 0 } detail ? Brief(detail) : value;
            text.WriteLine(shell switch
            {
                "bash" => value,
                "zsh" => value.Replace(":", "\\:") + ":" + help,
                _ => value + "\t" + help,
            });
        }
    }

    // The first sentence, up to a colon or semicolon, without a condition ("With --import: ").
    private static string Brief(string description)
    {
        if (description.StartsWith("With --", StringComparison.Ordinal)) description = description[(description.IndexOf(": ", StringComparison.Ordinal) + 1)..];
        return FirstPart().Match(description).Value.Trim();
    }

    [GeneratedRegex("^.*?(?=\\.( |$)|[;:(\\n]|$)")]
    private static partial Regex FirstPart();
}
