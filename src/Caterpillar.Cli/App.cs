using System;
using System.CommandLine;
using System.CommandLine.Help;
using System.CommandLine.Invocation;
using System.IO;
using System.Linq;
using System.Text.RegularExpressions;
using Caterpillar.Basics;
using Caterpillar.Cli.Batches;

namespace Caterpillar.Cli;

/// <summary>Parses the arguments, runs the verb, and turns every outcome into an exit code.</summary>
internal static partial class App
{
    public static int Run(string[] args, Session session)
    {
        // A file that was cut off is an error, not a shorter file.
        AppContext.SetSwitch("System.IO.Compression.UseStrictValidation", true);
        var root = new Command("caterpillar", "Turns designs into 3D-printer motion, and G-code back into toolpaths.") { new HelpOption(),
            new VersionOption() };
        var general = new GeneralOptions();
        general.AddTo(root);
        foreach (var verb in Verbs.All()) root.Subcommands.Add(verb);
        return Guarded(session, () =>
        {
            var parsed = root.Parse(args);
            if (parsed.CommandResult.Command is not Verb verb || parsed.Action is not (null or ParseErrorAction)) return Answer(parsed, root, session);
            var isBatch = verb.Batch?.IsGiven(parsed) == true;
            if (!(isBatch ? verb.Batch!.IsComplete(parsed) : parsed.Errors.Count == 0) || UsageMessages.UnknownOption(parsed) is not null)
                return Answer(parsed, root, session);
            general.Apply(parsed, session);
            if (isBatch) return Batch.Run(verb, parsed, session);
            verb.Batch?.RefuseAlone(parsed);
            OutputGuard.Check(verb, parsed);
            return verb.Run(parsed, session);
        });
    }

    /// <summary>Runs a verb by itself.</summary>
    public static int RunVerb(Verb verb, string[] words, Session session) => verb.Run(verb.Parse(words), session);

    /// <summary>Does work, and turns all that it may throw into a message and an exit code.</summary>
    public static int Guarded(Session session, Func<int> work)
    {
        try
        {
            return work();
        }
        catch (CliException end)
        {
            if (end.Message.Length > 0) session.Messages.WriteLine(end.Message);
            return end.Code;
        }
        catch (OperationCanceledException)
        {
            session.Messages.WriteLine("Interrupted; nothing was written.");
            return ExitCode.Interrupted;
        }
        catch (Exception disk) when (disk is IOException or UnauthorizedAccessException or InvalidDataException)
        {
            session.Messages.WriteLine(LongWords.Shorten(Sentence(disk)));
            return ExitCode.BadInput;
        }
        catch (DiagnosticException problem)
        {
            session.Print(problem.Diagnostics);
            return ExitCode.BadInput;
        }
        catch (Exception full) when (IsOutOfMemory(full))
        {
            session.LacksMemory = true;
            session.Messages.WriteLine($"This takes more memory than the limit of {MemoryLimit.Text(session.Memory.Bytes)}; nothing was written. "
                + Session.MoreMemory);
            return ExitCode.BadInput;
        }
        catch (Exception bug)
        {
            session.Messages.WriteLine("This is an internal error; please report it together with the input that caused it:");
            session.Messages.WriteLine(bug.ToString());
            return ExitCode.Bug;
        }
    }

    private static bool IsOutOfMemory(Exception problem)
        => problem is OutOfMemoryException || (problem is AggregateException several && several.Flatten().InnerExceptions.Any(IsOutOfMemory));

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

    // The runtime's messages give the full path; users know the one they typed as an argument.
    private static string Sentence(Exception disk) => disk switch
    {
        FileNotFoundException { FileName: { } file } => $"{Short(file)}: there is no such file.",
        DirectoryNotFoundException when Quoted().Match(disk.Message) is { Success: true } path
            => $"{Short(path.Groups[1].Value)}: there is no such folder.",
        UnauthorizedAccessException when Quoted().Match(disk.Message) is { Success: true } path => $"{Short(path.Groups[1].Value)}: access is denied.",
        _ => disk.Message,
    };

    [GeneratedRegex("'([^']*)'")]
    private static partial Regex Quoted();

    private static string Short(string file) => Path.GetRelativePath(Environment.CurrentDirectory, file) is var near && near.Length < file.Length ? near : file;
}
