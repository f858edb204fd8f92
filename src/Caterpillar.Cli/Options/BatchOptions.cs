namespace Caterpillar.Cli;

/// <summary>The options that run a verb many times.</summary>
internal sealed class BatchOptions
{
    public Described<string[]> Each { get; } = new("--each",
        "Run once for each of these files or patterns ('models/*.stl', 'models/**/*.stl'), instead of the input above.",
        "FILE|PATTERN") { AllowMultipleArgumentsPerToken = true };

    public Described<string?> Table { get; } = new("--table",
        "Run once for each row of a CSV table. Columns are keys (layer_height_mm), parameters of a turtle program or options (--scale). A column \"name\" "
            + "names the rows.", "FILE.csv");

    public Described<string?> Summary { get; } = new("--summary",
        "Output CSV table with a row for each run: status, message, layers, size, material, time; - = standard output.", "FILE.csv");

    public Described<bool> Resume { get; } = new("--resume",
        "Skip runs that the --summary file lists as done, if their options, inputs and output are unchanged.");

    public Described<int?> Jobs { get; } = new("--jobs",
        "Number of parallel runs of --each or --table, which share the memory. Default: one per core.", "N");

    public Described<string?> Part { get; } = new("--part", "Run only part I of N equal parts of the list, for array jobs on clusters.", "I/N");

    public Option[] All => [Each, Table, Summary, Resume, Jobs, Part];

    /// <summary>True if there are many runs.</summary>
    public bool IsGiven(ParseResult parsed) => IsGiven(parsed, Each) || IsGiven(parsed, Table);

    /// <summary>True if the command line has no error, apart from arguments that <c>--each</c> replaces.</summary>
    public bool IsComplete(ParseResult parsed)
        => parsed.UnmatchedTokens.Count == 0
            && (parsed.Errors.Count == 0 || (IsGiven(parsed, Each) && parsed.Errors.All(e => e.SymbolResult is not OptionResult)));

    /// <exception cref="CliException">An option of batches is given without <c>--each</c> or <c>--table</c>.</exception>
    public void RefuseAlone(ParseResult parsed)
    {
        if (Array.Find<Option>([Summary, Resume, Jobs, Part], o => IsGiven(parsed, o)) is { } option)
            throw CliException.Usage($"{option.Name} needs --each or --table.");
    }

    /// <exception cref="CliException"><c>--jobs</c> is out of range.</exception>
    public int Workers(ParseResult parsed, int calls)
    {
        if (parsed.GetValue(Jobs) is not { } given) return Math.Max(1, Math.Min(Environment.ProcessorCount, calls));
        if (given is < 1 or > 1024) throw CliException.Usage("--jobs needs a number from 1 to 1024.");
        return Math.Max(1, Math.Min(given, calls));
    }

    /// <summary>The runs of this part of the list.</summary>
    /// <exception cref="CliException"><c>--part</c> is invalid.</exception>
    public IReadOnlyList<T> PartOf<T>(IReadOnlyList<T> jobs, ParseResult parsed)
    {
        if (parsed.GetValue(Part) is not { } text) return jobs;
        var words = text.Split('/');
        if (words.Length != 2 || !NumberReader.TryParseInt(words[0], out var part) || !NumberReader.TryParseInt(words[1], out var parts)
            || part < 0 || part > parts || parts == 0)
        {
            throw CliException.Usage($"--part needs I/N, such as 3/20, not \"{text}\".");
        }
        return jobs.Where((_, i) => (i + 1) % parts == part % parts).ToArray();
    }

    /// <summary>The options that all runs share, as words.</summary>
    public IEnumerable<string> Shared(ParseResult parsed, Command verb)
    {
        foreach (var given in parsed.CommandResult.Children.OfType<OptionResult>())
        {
            if (given.Implicit || All.Contains(given.Option) || given.Option.Name == "--output" || !verb.Options.Contains(given.Option)) continue;
            foreach (var word in WordsOf(given)) yield return word;
        }
    }

    /// <summary>A given option as words: its name before each of its values.</summary>
    public static IEnumerable<string> WordsOf(OptionResult given)
        => given.Tokens.Count == 0 ? [given.Option.Name] : given.Tokens.SelectMany(token => new[] { given.Option.Name, token.Value });

    private static bool IsGiven(ParseResult parsed, Option option) => parsed.GetResult(option) is { Implicit: false };
}
