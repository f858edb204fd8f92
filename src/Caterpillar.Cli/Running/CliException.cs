namespace Caterpillar.Cli;

/// <summary>Ends the program with a message (none if everything has been reported already) and an exit code.</summary>
internal sealed class CliException(int code, string? message = null) : Exception(LongWords.Shorten(message ?? ""))
{
    public int Code { get; } = code;

    /// <summary>The end after a wrong command line.</summary>
    public static CliException Usage(string message) => new(ExitCode.Usage, message);
}
