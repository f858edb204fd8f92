namespace Caterpillar.Turtles;

/// <summary>Names of a script while it is compiled: globals, the locals of the current procedure, arrays, and the state of the turtle.</summary>
internal sealed class ScriptScope(IReadOnlyDictionary<string, Procedure> procedures) : IFormulaScope
{
    private static readonly Dictionary<string, Func<Turtle, double>> State = new(StringComparer.Ordinal)
    {
        ["turtle_x"] = t => t.X,
        ["turtle_y"] = t => t.Y,
        ["turtle_z"] = t => t.Z,
        ["turtle_yaw"] = t => t.Yaw,
        ["turtle_pitch"] = t => t.Pitch,
        ["turtle_roll"] = t => t.Roll,
        ["turtle_density"] = t => t.Density,
        ["turtle_area"] = t => t.Bead.Area,
        ["turtle_rate"] = t => t.Rate,
        ["turtle_speed"] = t => t.Speed,
        ["turtle_pen"] = t => t.IsPenDown ? 1 : 0,
    };

    private readonly Dictionary<string, int> _globals = new(StringComparer.Ordinal);
    private readonly Dictionary<string, int> _arrays = new(StringComparer.Ordinal);
    private readonly Dictionary<string, (GrayImage Image, bool Smooth)> _images = new(StringComparer.Ordinal);
    private Dictionary<string, int>? _locals;

    public int GlobalCount { get; private set; }

    public int ArrayCount => _arrays.Count;

    public bool InProcedure => _locals is not null;

    /// <summary>Slots that the current procedure needs.</summary>
    public int LocalCount { get; private set; }

    public IEnumerable<string> Names
        => (_locals?.Keys ?? Enumerable.Empty<string>()).Concat(_globals.Keys).Concat(_arrays.Keys).Concat(State.Keys).OrderBy(n => n, StringComparer.Ordinal);

    /// <summary>Visible variables: locals, and globals that no local hides.</summary>
    public IReadOnlyList<(string Name, int Slot, bool Local)> Variables
        => (_locals?.Select(l => (l.Key, l.Value, true)) ?? []).Concat(_globals.Where(g => _locals?.ContainsKey(g.Key) != true)
            .Select(g => (g.Key, g.Value, false))).OrderBy(v => v.Item1, StringComparer.Ordinal).ToArray();

    public static bool IsState(string name) => State.ContainsKey(name);

    /// <summary>Name of the number of the repetition, from 1, in the innermost repeat.</summary>
    public const string Counter = "repcount";

    /// <summary>Slots of the repeats around the current position in the current procedure.</summary>
    public Stack<(int Slot, bool Local)> Repeats { get; } = new();

    public void Enter(IReadOnlyList<string> parameters)
    {
        _locals = new Dictionary<string, int>(StringComparer.Ordinal);
        LocalCount = 0;
        foreach (var name in parameters) _locals[name] = LocalCount++;
    }

    public void Leave() => _locals = null;

    public int DeclareGlobal(string name)
    {
        if (!_globals.TryGetValue(name, out var slot)) _globals[name] = slot = GlobalCount++;
        return slot;
    }

    public int DeclareArray(string name)
    {
        if (!_arrays.TryGetValue(name, out var slot)) _arrays[name] = slot = _arrays.Count;
        return slot;
    }

    /// <summary>False if an image of that name exists.</summary>
    public bool DeclareImage(string name, GrayImage image, bool smooth)
    {
        if (_images.ContainsKey(name)) return false;
        _images.Add(name, (image, smooth));
        return true;
    }

    /// <summary>Names that only formulas of a shaping block can use, with their slots.</summary>
    public Dictionary<string, (int Slot, bool Local)> Coordinates { get; } = new(StringComparer.Ordinal);

    /// <summary>The coordinates that the formulas of the current block use.</summary>
    public HashSet<string> UsedCoordinates { get; } = new(StringComparer.Ordinal);

    /// <summary>A variable of the current procedure, or of the script outside of procedures.</summary>
    public (int Slot, bool Local) DeclareHere(string name)
    {
        if (_locals is null) return (DeclareGlobal(name), false);
        if (!_locals.TryGetValue(name, out var slot)) _locals[name] = slot = LocalCount++;
        return (slot, true);
    }

    /// <summary>The variable of an assignment: a local one, else a global one, else a new one here.</summary>
    public (int Slot, bool Local) ForAssignment(string name)
    {
        if (_locals is not null && _locals.TryGetValue(name, out var local)) return (local, true);
        return _globals.TryGetValue(name, out var global) ? (global, false) : DeclareHere(name);
    }

    /// <summary>Slots without names for the state of a loop.</summary>
    public (int Slot, bool Local) Hidden(int count)
    {
        if (_locals is null)
        {
            GlobalCount += count;
            return (GlobalCount - count, false);
        }
        LocalCount += count;
        return (LocalCount - count, true);
    }

    public int GlobalSlot(string name) => _globals.TryGetValue(name, out var slot) ? slot : -1;

    public int ArraySlot(string name) => _arrays.TryGetValue(name, out var slot) ? slot : -1;

    public FormulaNode? Variable(string name, Token at)
    {
        if (Coordinates.TryGetValue(name, out var given))
        {
            UsedCoordinates.Add(name);
            return new FormulaNode(c => c.Values[given.Local ? c.Base + given.Slot : given.Slot]);
        }
        var isLocal = _locals is not null && _locals.ContainsKey(name);
        if (isLocal || _globals.ContainsKey(name))
        {
            var slot = (isLocal ? _locals! : _globals)[name];
            return new FormulaNode(c =>
            {
                // Only finite numbers are ever assigned: NaN marks a variable without a value.
                var value = c.Values[isLocal ? c.Base + slot : slot];
                return double.IsNaN(value) ? throw new FormulaException("turtle.no_value", $"The variable '{name}' has no value yet.", at) : value;
            });
        }
        if (name == Counter && Repeats.Count > 0)
        {
            var (slot, inFrame) = Repeats.Peek();
            return new FormulaNode(c => c.Values[inFrame ? c.Base + slot : slot] + 1);
        }
        return State.TryGetValue(name, out var read) ? new FormulaNode(c => read(((ScriptMachine)c.Host!).Turtle)) : null;
    }

    public bool IsArray(string name) => _arrays.ContainsKey(name);

    /// <summary>True if a formula calls a procedure.</summary>
    public bool CallsFunctions { get; private set; }

    public IEnumerable<string> Functions => procedures.Keys.Concat(_images.Keys);

    /// <summary>True if formulas can call it.</summary>
    public bool IsFunction(string name) => _images.ContainsKey(name) || (procedures.TryGetValue(name, out var procedure) && procedure.ReturnsValue);

    public FormulaNode? Call(Token name, List<FormulaNode> arguments)
    {
        var isImage = _images.TryGetValue(name.Text, out var image);
        if (!procedures.TryGetValue(name.Text, out var procedure) && !isImage) return null;
        if (procedure is { ReturnsValue: false })
            throw new FormulaException("turtle.no_result", $"The procedure '{name.Text}' returns no value.", name);
        var count = procedure?.Parameters.Count ?? 2;
        if (arguments.Count != count)
        {
            throw new FormulaException("formula.arguments",
                $"'{name.Text}' takes {NumberFormatter.Format(count)} {(count == 1 ? "value" : "values")}, not {NumberFormatter.Format(arguments.Count)}.",
                name);
        }
        var values = arguments.ConvertAll(a => a.Evaluate).ToArray();
        var depth = arguments.Select(a => a.Depth).DefaultIfEmpty(0).Max() + 1;
        CallsFunctions |= procedure is not null;
        if (procedure is not null) return new FormulaNode(c => ((ScriptMachine)c.Host!).Call(procedure, values, name), depth);
        var (u, v) = (values[0], values[1]);
        return image.Smooth
            ? new FormulaNode(c => image.Image.Between(u(c), v(c)), depth)
            : new FormulaNode(c => image.Image.Nearest(u(c), v(c)), depth);
    }

    public FormulaNode? Element(string name, FormulaNode index, Token at)
    {
        var slot = _arrays[name];
        var evaluate = index.Evaluate;
        return new FormulaNode(
            c =>
            {
                var array = c.Arrays[slot];
                return array is null
                    ? throw new FormulaException("turtle.index", $"The array '{name}' has not been created yet.", at)
                    : array[Index(evaluate(c), array.Length, name, at)];
            },
            index.Depth + 1);
    }

    public static int Index(double index, int length, string name, Token at)
    {
        if (index >= 0 && index < length && index == Math.Floor(index)) return (int)index;
        var shown = double.IsNaN(index) || double.IsInfinity(index) ? "This index" : NumberFormatter.Format(index, 6);
        throw new FormulaException("turtle.index", $"{shown} is not an index of '{name}'. Its indices are 0 to {NumberFormatter.Format(length - 1)}.", at);
    }
}
