namespace Caterpillar.Cli;

/// <summary>An option with what the help says of it.</summary>
internal sealed class Described<T> : Option<T>
{
    /// <param name="name">The name with its dashes.</param>
    /// <param name="description">What it does, in sentences.</param>
    /// <param name="value">What stands for its value; null for the name, or for a switch.</param>
    /// <param name="aliases">Other names.</param>
    public Described(string name, string description, string? value = null, params string[] aliases)
        : base(name, aliases)
    {
        Description = description;
        HelpName = value;
    }
}
