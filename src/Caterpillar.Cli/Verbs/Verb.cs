namespace Caterpillar.Cli;

/// <summary>A verb of the program. Its file declares its arguments and options and does its work; <see cref="Verbs"/> lists it.</summary>
/// <param name="name">The word of the command line.</param>
/// <param name="description">What it does, in a sentence.</param>
/// <param name="writes">Kinds of files that it writes, in the words of <see cref="FileGuard"/>.</param>
/// <param name="ending">The usual extension of its output, such as <c>.gcode</c>; null if it writes no file.</param>
internal abstract class Verb(string name, string description, string[]? writes = null, string? ending = null) : Command(name, description)
{
    /// <summary>Command lines for the help, each with its description.</summary>
    public IReadOnlyList<(string Line, string Does)> Examples
        => [.. EmbeddedText.Rows("usage/Examples.tsv", typeof(Verb)).Where(r => r[0].Split(' ')[0] == Name).Select(r => (r[0], r[1]))];

    /// <summary>Kinds of files that it writes.</summary>
    public string[] Writes { get; } = writes ?? [];

    /// <summary>The usual extension of its output, or null.</summary>
    public string? Ending { get; } = ending;

    /// <summary>The options of batches, or null.</summary>
    public BatchOptions? Batch { get; private set; }

    /// <summary>True if its output may replace its input.</summary>
    public virtual bool ReplacesInput(ParseResult arguments) => false;

    /// <summary>Does the work and returns the exit code. Problems may also end in a <see cref="CliException"/>; I/O exceptions may pass through.</summary>
    public abstract int Run(ParseResult arguments, Session session);

    protected void Add(params IEnumerable<Option> options)
    {
        foreach (var option in options) Options.Add(option);
    }

    /// <summary>Adds the options of batches.</summary>
    protected void AllowBatches() => Add((Batch = new BatchOptions()).All);
}
