namespace Caterpillar.Cli;

/// <summary>An option with its description in the help.</summary>
internal sealed class Described<T> : Option<T>
{
    /// <param name="name">The name with its dashes.</param>
    /// <param name="description">Its description, in sentences.</param>
    /// <param name="value">Placeholder of its value; null = its name, or a switch.</param>
    /// <param name="aliases">Other names.</param>
    public Described(string name, string description, string? value = null, params string[] aliases)
        : base(name, aliases)
    {
        Description = description;
        HelpName = value;
    }
}
