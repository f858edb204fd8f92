namespace Caterpillar.Cli;

/// <summary>Writes completions for a shell.</summary>
internal sealed class CompletionsVerb : Verb
{
    private readonly Argument<string> _shell = new("SHELL") { Description = "Shell to write completions for." };

    public CompletionsVerb()
        : base("completions", "Write shell completions for commands, options and values.")
    {
        _shell.AcceptOnlyFromAmong("bash", "zsh", "fish", "powershell");
        Arguments.Add(_shell);
    }

    public override int Run(ParseResult arguments, Session session)
    {
        var table = CompletionTable.Of((Command?)Parents.OfType<Command>().FirstOrDefault() ?? this);
        Action<TextWriter, CompletionTable> write = arguments.GetValue(_shell) switch
        {
            "zsh" => ZshCompletions.Write,
            "fish" => FishCompletions.Write,
            "powershell" => PowerShellCompletions.Write,
            _ => BashCompletions.Write,
        };
        session.WriteText("-", text => write(text, table));
        return ExitCode.Done;
    }
}
