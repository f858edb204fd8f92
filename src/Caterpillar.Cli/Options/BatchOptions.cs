using System.CommandLine.Parsing;

namespace Caterpillar.Cli;

/// <summary>The options that make many calls of one.</summary>
internal sealed class BatchOptions
{
    public Described<string[]> Each { get; } = new("--each",
        "Do the same with each of these files, instead of the files named above; patterns such as 'models/*.stl' and 'models/**/*.stl' are understood.",
        "FILE|PATTERN") { AllowMultipleArgumentsPerToken = true };

    public Described<string?> Table { get; } = new("--table",
        "Do the same for each row of a table (CSV). Its columns are settings (layer_height_mm), parameters of a turtle program, or options (--scale); a column "
            + "called name names the rows.", "FILE.csv");

    public Described<string?> Summary { get; } = new("--summary",
        "Write a table of what each call of --each or --table made: status, message, layers, size, material, time; - is standard output.", "FILE.csv");

    public Described<bool> Resume { get; } = new("--resume",
        "Skip what the summary of an earlier run says is done, where options, inputs and output are still the same.");

    public Described<int?> Jobs { get; } = new("--jobs",
        "How many calls of --each or --table run at a time; by default one for each core. They share the memory.", "N");

    public Described<string?> Part { get; } = new("--part", "Do only the I-th of N equal parts of the list, for array jobs of clusters.", "I/N");

    public Option[] All => [Each, Table, Summary, Resume, Jobs, Part];

    public bool Holds(Option option) => All.Contains(option);

    /// <summary>True if many calls are wanted.</summary>
    public bool IsGiven(ParseResult parsed) => IsGiven(parsed, Each) || IsGiven(parsed, Table);

    /// <summary>True if the command line is right but for arguments that are missing because <c>--each</c> names them.</summary>
    public bool IsComplete(ParseResult parsed)
        => parsed.UnmatchedTokens.Count == 0
            && (parsed.Errors.Count == 0 || (IsGiven(parsed, Each) && parsed.Errors.All(e => e.SymbolResult is not OptionResult)));

    /// <exception cref="CliException">An option of batches stands without one that makes a batch (wrong usage).</exception>
    public void RefuseAlone(ParseResult parsed)
    {
        if (Array.Find<Option>([Summary, Resume, Jobs, Part], o => IsGiven(parsed, o)) is { } option)
            throw new CliException(ExitCode.Usage, $"{option.Name} needs --each or --table.");
    }

    /// <exception cref="CliException">It is no number of calls.</exception>
    public int Workers(ParseResult parsed, int calls)
    {
        if (parsed.GetValue(Jobs) is not { } given) return Math.Max(1, Math.Min(Environment.ProcessorCount, calls));
        if (given is < 1 or > 1024) throw new CliException(ExitCode.Usage, "--jobs needs a number from 1 to 1024.");
        return Math.Max(1, Math.Min(given, calls));
    }

    /// <summary>The calls of this part of the list.</summary>
    /// <exception cref="CliException">It is no part.</exception>
    public IReadOnlyList<T> PartOf<T>(IReadOnlyList<T> jobs, ParseResult parsed)
    {
        if (parsed.GetValue(Part) is not { } text) return jobs;
        var words = text.Split('/');
        if (words.Length != 2 || !NumberReader.TryParseInt(words[0], out var part) || !NumberReader.TryParseInt(words[1], out var parts) || part < 1
            || part > parts)
        {
            throw new CliException(ExitCode.Usage, $"--part {text}: expected a part and their number, such as 3/20.");
        }
        return jobs.Where((_, i) => i % parts == part - 1).ToArray();
    }

    /// <summary>The options of the command line that each call gets, as words.</summary>
    public IEnumerable<string> Shared(ParseResult parsed, Command verb)
    {
        foreach (var given in parsed.CommandResult.Children.OfType<OptionResult>())
        {
            if (given.Implicit || Holds(given.Option) || given.Option.Name == "--output" || !verb.Options.Contains(given.Option)) continue;
            if (given.Tokens.Count == 0) yield return given.Option.Name;
            foreach (var token in given.Tokens)
            {
                yield return given.Option.Name;
                yield return token.Value;
            }
        }
    }

    private static bool IsGiven(ParseResult parsed, Option option) => parsed.GetResult(option) is { Implicit: false };
}
