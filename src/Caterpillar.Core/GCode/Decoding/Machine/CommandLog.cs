namespace Caterpillar.GCode;

/// <summary>The commands of a file: those without effect on the toolpath, those that matter for a print, and those that are not understood.</summary>
internal sealed class CommandLog(Machine machine)
{
    /// <summary>Code of the note about commands that are not understood.</summary>
    public const string NotUnderstood = "gcode.not_understood";

    private const int MaxNames = 1000;
    private const int MaxShown = 20;
    private const int LongestName = 60;
    private readonly FlavorCommands _commands = FlavorCommands.Of(machine.Rules);
    private readonly SortedDictionary<string, int> _ignored = new(StringComparer.Ordinal);
    private readonly Dictionary<FlavorCommand, UsedCommand> _known = [];
    private readonly Dictionary<string, UsedCommand> _unknown = new(StringComparer.Ordinal);
    private readonly List<UsedCommand> _used = [];
    private FlavorCommand? _last;

    // The last macro before the first extrusion.
    private UsedCommand? _macro;

    /// <summary>Commands without effect on the toolpath, and their counts.</summary>
    public IReadOnlyDictionary<string, int> Ignored => _ignored;

    /// <summary>Commands that are not harmless everywhere, in the order of their first lines.</summary>
    public IReadOnlyList<UsedCommand> Used => _used;

    /// <summary>Looks a command up before it is executed.</summary>
    public void See(byte[] text, int start, int end)
    {
        var command = new CommandText(text, start, end);
        _last = _commands.Find(command);
        if (_last is { Use: CommandUse.Ok or CommandUse.Tracked or CommandUse.Ignored }) return;
        var use = UseOf(command);
        use.Add(machine.Diagnostics.Line, machine.Moves.Count);
        var isMacro = command.IsCode ? _last?.Name == "M98" : machine.Rules.ExtendedCommands && _last is null or { Class: CommandClass.Flow };
        if (!isMacro || machine.Counters.Prints > 0) return;
        _macro = use;
        machine.Restate(0, ChunkParser.HasX | ChunkParser.HasY | ChunkParser.HasZ);
    }

    /// <summary>The file prints before it has stated the position after a macro.</summary>
    public void PrintsLost(int axes)
    {
        if (_macro is not null) _macro.UnknownAxes = string.Join(", ", "XYZ".Where((_, i) => (axes & (1 << i)) != 0));
    }

    /// <summary>The command that was seen last has no effect on the toolpath.</summary>
    public void Ignore()
    {
        if (_last is null) return;
        var name = _last.Name.TrimEnd('*');
        if (_ignored.TryGetValue(name, out var count)) _ignored[name] = count + 1;
        else if (_ignored.Count < MaxNames) _ignored.Add(name, 1);
        if (_last.Use == CommandUse.Untracked || (_last.Use is CommandUse.Never or CommandUse.Depends
            && _last.Class is CommandClass.Motion or CommandClass.Position or CommandClass.Home))
        {
            NotFollowed(name);
        }
    }

    public void NotFollowed(string name)
        => machine.Diagnostics.Warn("gcode.unsupported_motion",
            $"{machine.Rules.Title}: {name} moves the head or shifts its coordinates, but the decoder cannot follow it. Positions after it may be wrong.");

    /// <summary>Adds a note about everything that was ignored, and one about what is not understood.</summary>
    public void Report()
    {
        var list = machine.Diagnostics.List;
        if (_ignored.Count > 0)
        {
            var names = _ignored.Select(p => p.Key + " (" + NumberFormatter.Format(p.Value) + ")").ToArray();
            list.Add(Severity.Note, "gcode.ignored", "Commands without effect on the toolpath: " + Listed(names) + ".", count: _ignored.Values.Sum());
        }
        var unknown = _used.Where(u => u.Command is null).ToArray();
        if (unknown.Length == 0) return;
        list.Add(Severity.Note, NotUnderstood, $"{Listed(unknown.Select(u => u.ToString()).ToArray())} not understood by {machine.Rules.Title}. "
            + "What follows is unverified.", new SourceLocation(Line: unknown[0].Places[0].Line), unknown.Sum(u => u.Places.Sum(p => p.Count)));
    }

    /// <summary>Some of these names, and the number of the others.</summary>
    internal static string Listed(IReadOnlyList<string> names)
        => string.Join(", ", names.Take(MaxShown)) + (names.Count > MaxShown ? " and " + NumberFormatter.Format(names.Count - MaxShown) + " more" : "");

    private UsedCommand UseOf(in CommandText command)
    {
        if (_last is { } known)
        {
            if (!_known.TryGetValue(known, out var use)) _used.Add(_known[known] = use = new UsedCommand(NameOf(command), known));
            return use;
        }
        var name = _unknown.Count < MaxNames ? NameOf(command) : "others";
        if (!_unknown.TryGetValue(name, out var other)) _used.Add(_unknown[name] = other = new UsedCommand(name, null));
        return other;
    }

    private static string NameOf(in CommandText command)
    {
        var name = new char[Math.Min(command.Length, LongestName)];
        for (var i = 0; i < name.Length; i++) name[i] = command[i] is >= ' ' and < (char)127 and var c ? c : '?';
        return new string(name);
    }
}
