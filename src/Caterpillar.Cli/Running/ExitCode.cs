namespace Caterpillar.Cli;

/// <summary>Exit codes of the program.</summary>
internal static class ExitCode
{
    public const int Done = 0;

    /// <summary>The input is bad, or a file cannot be read or written. Nothing was written.</summary>
    public const int BadInput = 1;

    /// <summary>The command line is wrong.</summary>
    public const int Usage = 2;

    /// <summary>A check refused to write, or found errors.</summary>
    public const int Refused = 3;

    /// <summary>An internal error.</summary>
    public const int Bug = 70;

    public const int Interrupted = 130;
}
