namespace Caterpillar.GCode;

/// <summary>A command that is not harmless everywhere in a print, and where the file uses it.</summary>
/// <param name="name">The command as in the file.</param>
/// <param name="command">What the firmware does with it. Null = it is not understood.</param>
internal sealed class UsedCommand(string name, FlavorCommand? command)
{
    // Beyond these only the last place is kept.
    private const int Most = 100;
    private readonly List<CommandPlace> _places = [];

    public string Name => name;

    public FlavorCommand? Command => command;

    /// <summary>Axes that the file has not stated between this command, which may move the head, and the first extrusion. Empty = none.</summary>
    public string UnknownAxes { get; set; } = "";

    /// <summary>Its places, in the order of the file. Those without a move between them are one.</summary>
    public IReadOnlyList<CommandPlace> Places => _places;

    /// <summary>Adds a place: the line, and the number of moves before it.</summary>
    public void Add(int line, int move)
    {
        var last = _places.Count - 1;
        if (last >= 0 && _places[last].Move == move) _places[last] = _places[last] with { Count = _places[last].Count + 1 };
        else if (_places.Count < Most) _places.Add(new CommandPlace(line, move, 1));
        else _places[last] = new CommandPlace(line, move, _places[last].Count + 1);
    }

    /// <summary>For example <c>M206 (line 12, 3 times)</c>.</summary>
    public static string Named(string name, int line, int count)
        => $"{name} (line {NumberFormatter.Format(line)}{(count > 1 ? ", " + NumberFormatter.Format(count) + " times" : "")})";

    public override string ToString() => Named(name, _places[0].Line, _places.Sum(p => p.Count));
}

/// <summary>A line of a file, the number of moves before it, and how often the command occurs there.</summary>
internal readonly record struct CommandPlace(int Line, int Move, int Count);
