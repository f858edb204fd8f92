namespace Caterpillar.Cli;

/// <summary>The limit of address space of this process (<c>ulimit -v</c>). Uses nothing of the library, which could not be loaded.</summary>
internal static class AddressSpace
{
    private const long Least = 5L << 29, ForEachThread = 1L << 28;

    /// <summary>A message if the limit is too small for the runtime, otherwise null.</summary>
    public static string? TooSmall()
    {
        var needed = Least + ForEachThread * Environment.ProcessorCount;
        return Limit() is { } limit && limit < needed
            ? $"The address space is limited to {Megabytes(limit)} MB (ulimit -v). The program needs at least {Megabytes(needed)} MB on this machine."
            : null;
    }

    private static long? Limit()
    {
        const string File = "/proc/self/limits";
        if (!System.IO.File.Exists(File)) return null;
        // For example "Max address space         1048576000           unlimited            bytes".
        var line = System.IO.File.ReadAllText(File).Split('\n').FirstOrDefault(l => l.StartsWith("Max address space", StringComparison.Ordinal)) ?? "";
        var words = line.Split(' ', StringSplitOptions.RemoveEmptyEntries);
        return words.Length > 3 && long.TryParse(words[3], NumberStyles.None, CultureInfo.InvariantCulture, out var bytes) ? bytes : null;
    }

    private static string Megabytes(long bytes) => (bytes >> 20).ToString(CultureInfo.InvariantCulture);
}
