namespace Caterpillar.Flavors;

/// <summary>The commands of a flavor: what each does with these words. A lookup allocates nothing.</summary>
internal sealed class FlavorCommands
{
    private static readonly Dictionary<string, Lazy<FlavorCommands>> OfFlavors
        = FlavorTable.All.ToDictionary(f => f.Name, f => new Lazy<FlavorCommands>(() => new FlavorCommands(f.Name)), StringComparer.Ordinal);
    private readonly Dictionary<uint, FlavorCommand[]> _byHash;
    private readonly FlavorCommand[] _prefixes;

    private FlavorCommands(string flavor)
    {
        var all = Commands(flavor).ToArray();
        _prefixes = Array.FindAll(all, c => IsPrefix(c.Name));
        _byHash = all.Where(c => !IsPrefix(c.Name)).GroupBy(c => HashOf(c.Name)).ToDictionary(g => g.Key, g => g.ToArray());
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
        if ((text.IsCode || text[0] == '$') && length > 1 && Find(text, 1) is { } first) return first;
        if (text.IsCode) return null;
        foreach (var prefix in _prefixes)
        {
            if (text.Begins(prefix.Name, prefix.Name.Length - 1)) return prefix;
        }
        return null;
    }

    private FlavorCommand? Find(in CommandText text, int length)
    {
        if (!_byHash.TryGetValue(text.Hash(length), out var commands)) return null;
        foreach (var command in commands)
        {
            if (command.Name.Length == length && text.Begins(command.Name, length) && text.Fits(command.When)) return command;
        }
        return null;
    }

    // Own rows first, then those of single makers.
    private static IEnumerable<FlavorCommand> Commands(string flavor)
    {
        if (flavor == FlavorTable.Slicer.Name) return CommandTable.Rows.SelectMany(r => r.Commands);
        string[] names = flavor == FlavorTable.Marlin2.Name ? [flavor, "buddy"] : flavor == FlavorTable.Grbl.Name ? [flavor, "fluidnc"] : [flavor];
        return names.SelectMany(name => CommandTable.Rows.Where(r => r.Flavors.Contains(name)).SelectMany(r => r.Commands));
    }

    private static bool IsPrefix(string name) => name[name.Length - 1] == '*';

    private static uint HashOf(string name)
    {
        var text = System.Text.Encoding.UTF8.GetBytes(name);
        return new CommandText(text, 0, text.Length) is var command ? command.Hash(command.Length) : 0;
    }
}
