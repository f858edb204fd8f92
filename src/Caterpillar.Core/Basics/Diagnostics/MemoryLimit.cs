namespace Caterpillar.Basics;

/// <summary>
/// Memory limit of a call. Work estimates its need before it begins, and readers count as they go. Exceeding the limit is an error
/// (<c>memory.limit</c>) with the amount and the cause. The estimates cover data that grows with the input, not the needs of the runtime.
/// </summary>
public sealed record MemoryLimit
{
    /// <summary>Code of the error.</summary>
    public const string Code = "memory.limit";

    // Where the runtime does not know the size of the machine.
    private const long UsualMachine = 8L << 30;

    /// <param name="bytes">At least one.</param>
    /// <exception cref="ArgumentOutOfRangeException">The number is zero or negative.</exception>
    public MemoryLimit(long bytes) => Bytes = bytes > 0 ? bytes : throw new ArgumentOutOfRangeException(nameof(bytes));

    /// <summary>Half of the memory of the machine, or of the container if it has a limit.</summary>
    public static MemoryLimit Default { get; } = new(Machine() / 2);

    /// <summary>The limit in bytes.</summary>
    public long Bytes { get; }

    /// <summary>An error if this many bytes exceed the limit, otherwise null.</summary>
    /// <param name="bytes">Total need of the work.</param>
    /// <param name="what">Subject of the sentence: "An array of 3 numbers".</param>
    /// <param name="source">Source of the request.</param>
    /// <param name="remedy">A sentence with the remedy, or null.</param>
    internal Diagnostic? Refuse(double bytes, string what, SourceLocation? source = null, string? remedy = null)
    {
        if (bytes <= Bytes) return null;
        var message = $"{what} would take {About(bytes)} of memory. The limit is {Text(Bytes)}.";
        return new Diagnostic(Severity.Error, Code, remedy is null ? message : message + " " + remedy, source);
    }

    /// <summary>The same for work that cannot return diagnostics.</summary>
    /// <exception cref="DiagnosticException">The need exceeds the limit.</exception>
    public void Check(double bytes, string what, SourceLocation? source = null, string? remedy = null)
    {
        if (Refuse(bytes, what, source, remedy) is { } error) throw new DiagnosticException([error]);
    }

    /// <summary>For example <c>1.5 GB</c>, in powers of 1024, as operating systems count memory.</summary>
    public static string Text(double bytes)
    {
        string[] units = ["bytes", "KB", "MB", "GB", "TB"];
        var unit = 0;
        while (unit < units.Length - 1 && bytes >= 1000)
        {
            bytes /= 1024;
            unit++;
        }
        return NumberFormatter.Format(bytes, bytes < 10 ? 1 : 0) + " " + units[unit];
    }

    // Also where an estimate overflows.
    private static string About(double bytes) => bytes < 1L << 60 ? "about " + Text(bytes) : "more than a million TB";

    private static long Machine()
    {
#if NET8_0_OR_GREATER
        return GC.GetGCMemoryInfo().TotalAvailableMemoryBytes is > 0 and var known ? known : UsualMachine;
#else
        return OfLinux() ?? UsualMachine;
    }

    private static long? OfLinux()
    {
        const string File = "/proc/meminfo";
        try
        {
            if (!System.IO.File.Exists(File)) return null;
            using var lines = new StreamReader(File);
            // For example "MemTotal:  16318480 kB".
            var words = (lines.ReadLine() ?? "").Split([' '], StringSplitOptions.RemoveEmptyEntries);
            return words.Length == 3 && long.TryParse(words[1], NumberStyles.None, CultureInfo.InvariantCulture, out var kilobytes) && kilobytes > 0
                ? kilobytes << 10 : null;
        }
        catch (Exception closed) when (closed is IOException or UnauthorizedAccessException)
        {
            return null;
        }
#endif
    }
}
