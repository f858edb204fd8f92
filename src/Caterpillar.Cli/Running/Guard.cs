namespace Caterpillar.Cli;

/// <summary>Turns every exception into a message and an exit code.</summary>
internal static partial class Guard
{
    /// <summary>Does the work.</summary>
    public static int Run(Session session, Func<int> work)
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
            session.Messages.WriteLine(Session.Interrupted);
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
            session.Messages.WriteLine($"Out of memory: the limit is {MemoryLimit.Text(session.Memory.Bytes)}. Nothing was written. "
                + Session.MoreMemory);
            return ExitCode.BadInput;
        }
        catch (Exception bug)
        {
            session.Messages.WriteLine("Internal error. Please report it with the input that caused it:");
            session.Messages.WriteLine(bug.ToString());
            return ExitCode.Bug;
        }
    }

    private static bool IsOutOfMemory(Exception problem)
        => problem is OutOfMemoryException || (problem is AggregateException several && several.Flatten().InnerExceptions.Any(IsOutOfMemory))
            || (problem.InnerException is { } cause && IsOutOfMemory(cause));

    // Messages of the runtime have full paths. Users expect the path that they typed.
    private static string Sentence(Exception disk) => disk switch
    {
        FileNotFoundException { FileName: { } file } => $"{Short(file)}: file not found.",
        DirectoryNotFoundException when Quoted().Match(disk.Message) is { Success: true } path
            => $"{Short(path.Groups[1].Value)}: folder not found.",
        UnauthorizedAccessException when Quoted().Match(disk.Message) is { Success: true } path => $"{Short(path.Groups[1].Value)}: access denied.",
        _ => disk.Message,
    };

    [GeneratedRegex("'([^']*)'")]
    private static partial Regex Quoted();

    private static string Short(string file) => Path.GetRelativePath(Environment.CurrentDirectory, file) is var near && near.Length < file.Length ? near : file;
}
