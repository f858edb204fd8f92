using System.CommandLine;

namespace Caterpillar.Cli;

/// <summary>A verb of the program. Its file in <c>Commands/</c> declares its arguments and options and does its work; <see cref="Verbs"/> lists it.</summary>
internal abstract class Verb(string name, string description) : Command(name, description)
{
    /// <summary>What kinds of files it writes, in the words of <see cref="OutputGuard"/>.</summary>
    public virtual string[] Writes => [];

    /// <summary>True where it was told that its output may replace its input.</summary>
    public virtual bool ReplacesInput(ParseResult arguments) => false;

    /// <summary>Does the work and returns the exit code. Problems may also end in a <see cref="CliException"/>; I/O exceptions may pass through.</summary>
    public abstract int Run(ParseResult arguments, Session session);
}
