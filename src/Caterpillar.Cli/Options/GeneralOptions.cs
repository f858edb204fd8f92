namespace Caterpillar.Cli;

/// <summary>Options of every verb.</summary>
internal sealed class GeneralOptions
{
    // The runtime takes this much for itself.
    private const double LeastMemory = 64 << 20;

    private static readonly (string Name, double Bytes)[] Units = [("KB", 1 << 10), ("MB", 1 << 20), ("GB", 1 << 30), ("TB", 1L << 40)];

    private readonly Described<bool> _quiet = new("--quiet", "Print only errors and warnings.", null, "-q") { Recursive = true };

    private readonly Described<string?> _memory = new("--memory-limit",
        "Maximum memory, such as 500MB, 4GB or 75%. Default: half of the machine's memory.", "SIZE") { Recursive = true };

    public Option[] All => [_quiet, _memory];

    /// <exception cref="CliException">The limit is not a size.</exception>
    public void Apply(ParseResult parsed, Session session)
    {
        session.Quiet = parsed.GetValue(_quiet);
        if (parsed.GetValue(_memory) is { } text) session.Memory = Limit(text);
        session.EnforceMemory?.Invoke(session.Memory);
    }

    /// <summary>The memory limit of a size such as <c>4GB</c> or <c>75%</c>.</summary>
    /// <exception cref="CliException">The text is not a size.</exception>
    public static MemoryLimit Limit(string text)
    {
        var plain = text.Trim();
        (string Name, double Bytes)[] units = [("%", 2.0 * MemoryLimit.Default.Bytes / 100), .. Units];
        var unit = units.FirstOrDefault(u => plain.EndsWith(u.Name, StringComparison.OrdinalIgnoreCase));
        var isSize = NumberReader.TryParse(plain[..^(unit.Name ?? "").Length].Trim(), out var count) && (unit.Name != "%" || count <= 100);
        var bytes = isSize ? count * unit.Bytes : 0;
        return bytes is >= LeastMemory and < 1L << 60
            ? new MemoryLimit((long)bytes)
            : throw CliException.Usage($"--memory-limit needs a size of at least 64 MB, such as 500MB, 4GB or 75%, not \"{text}\".");
    }
}
