namespace Caterpillar.Flavors;

/// <summary>The commands of a flavor: what each does with these words. A lookup allocates nothing.</summary>
internal sealed class FlavorCommands
{
    private static readonly Dictionary<string, Lazy<FlavorCommands>> OfFlavors
        = FlavorTable.All.ToDictionary(f => f.Name, f => new Lazy<FlavorCommands>(() => new FlavorCommands(f.Name)), StringComparer.Ordinal);
    private readonly ConcurrentDictionary<uint, FlavorCommand[]> _byHash = new();
    private readonly Lazy<FlavorCommand[]> _prefixes;

    // Own commands first, then those of single makers.
    private readonly string[] _flavors;

    private FlavorCommands(string flavor)
    {
        _flavors = flavor == FlavorTable.Slicer.Name ? []
            : flavor == FlavorTable.Marlin2.Name ? [flavor, "buddy"] : flavor == FlavorTable.Grbl.Name ? [flavor, "fluidnc"] : [flavor];
        _prefixes = new Lazy<FlavorCommand[]>(() => CommandTable.Prefixes(_flavors));
    }

    /// <summary>The commands of a flavor. The neutral one has those of all.</summary>
    public static FlavorCommands Of(FlavorRules flavor)
        => OfFlavors.TryGetValue(flavor.Name, out var own) ? own.Value : OfFlavors[FlavorTable.Slicer.Name].Value;

    /// <summary>What a line of G-code without comment does. Null if the flavor does not have its command.</summary>
    public FlavorCommand? Find(string line)
    {
        var text = System.Text.Encoding.UTF8.GetBytes(line);
        return Find(new CommandText(text, 0, text.Length));
    }

    /// <summary>The same for a command of a line.</summary>
    public FlavorCommand? Find(in CommandText text)
    {
        var length = text.Length;
        if (length == 0) return null;
        if (Find(text, length) is { } command) return command;
        // T and O with any number, $ with anything.
        if ((text.IsCode || text[0] == '$') && Find(text, 1) is { } first) return first;
        if (text.IsCode) return null;
        foreach (var prefix in _prefixes.Value)
        {
            if (text.Begins(prefix.Name, prefix.Name.Length - 1)) return prefix;
        }
        return null;
    }

    private FlavorCommand? Find(in CommandText text, int length)
    {
        var hash = text.Hash(length);
        if (!_byHash.TryGetValue(hash, out var commands))
        {
            commands = CommandTable.WithHash(hash, _flavors);
            // There is no end of unknown names.
            if (commands.Length > 0) _byHash[hash] = commands;
        }
        foreach (var command in commands)
        {
            if (command.Name.Length == length && text.Begins(command.Name, length) && text.Fits(command.When)) return command;
        }
        return null;
    }
}
