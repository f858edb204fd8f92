namespace Caterpillar.Cli;

/// <summary>A verb of the program. Its file declares its arguments and options and does its work; <see cref="Verbs"/> lists it.</summary>
internal abstract class Verb(string name, string description) : Command(name, description)
{
    /// <summary>Command lines for the help, each with its description.</summary>
    public abstract IReadOnlyList<(string Line, string Does)> Examples { get; }

    /// <summary>Kinds of files that it writes, in the words of <see cref="OutputGuard"/>.</summary>
    public virtual string[] Writes => [];

    /// <summary>The usual extension of its output, such as <c>.gcode</c>; null if it writes no file.</summary>
    public virtual string? Ending => null;

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
