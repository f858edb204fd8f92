using System.CommandLine.Help;
using System.CommandLine.Invocation;

namespace Caterpillar.Cli;

/// <summary>Parses the arguments, runs the verb, and turns every outcome into an exit code.</summary>
internal static class App
{
    public static int Run(string[] args, Session session)
    {
        // A file that was cut off is an error, not a shorter file.
        AppContext.SetSwitch("System.IO.Compression.UseStrictValidation", true);
        var root = new Command("caterpillar", "Slice models, turn designs into G-code, and edit, check and view G-code.")
        {
            new HelpOption { Description = "Show help." }, new VersionOption { Description = "Show the version." },
        };
        var general = new GeneralOptions();
        foreach (var option in general.All) root.Options.Add(option);
        foreach (var verb in Verbs.All()) root.Subcommands.Add(verb);
        return Guard.Run(session, () =>
        {
            var parsed = root.Parse(args);
            if (parsed.CommandResult.Command is not Verb verb || parsed.Action is not (null or ParseErrorAction)) return Answer(parsed, root, session);
            var isBatch = verb.Batch?.IsGiven(parsed) == true;
            if (!(isBatch ? verb.Batch!.IsComplete(parsed) : parsed.Errors.Count == 0) || UsageMessages.UnknownOption(parsed) is not null)
                return Answer(parsed, root, session);
            general.Apply(parsed, session);
            if (isBatch) return Batch.Run(verb, parsed, session);
            verb.Batch?.RefuseAlone(parsed);
            FileGuard.Check(verb, parsed);
            FileGuard.CheckFolders(parsed);
            return verb.Run(parsed, session);
        });
    }

    // Help and version, or wrong usage.
    private static int Answer(ParseResult parsed, Command root, Session session)
    {
        if (parsed.Errors.Count == 0 && parsed.Action is not null)
        {
            session.WriteText("-", text =>
            {
                parsed.Invoke(new InvocationConfiguration { Output = text, Error = session.Messages });
                if (parsed.Action is HelpAction && parsed.CommandResult.Command is Verb explained) WriteExamples(explained, text);
            });
            return ExitCode.Done;
        }
        foreach (var error in UsageMessages.Of(parsed, root)) session.Messages.WriteLine(LongWords.Shorten(error));
        var verb = parsed.CommandResult.Command is Verb v ? " " + v.Name : "";
        session.Messages.WriteLine($"See: caterpillar{verb} --help");
        return ExitCode.Usage;
    }

    private static void WriteExamples(Verb verb, TextWriter text)
    {
        text.WriteLine("Examples:");
        foreach (var (line, does) in verb.Examples) text.WriteLine($"  # {does}\n  caterpillar {line}");
        text.WriteLine();
    }
}
