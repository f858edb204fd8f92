namespace Caterpillar.Turtles;

/// <summary>The action of a block on the paths drawn in it. Each is named after a component.</summary>
internal enum ShapingKind : byte
{
    Deform,
    Modulate,
    GapBead,
    CoolLayers,
}

/// <summary>A compiled shaping block: its kind and the formulas of its header.</summary>
internal sealed class ShapingRules(ShapingKind kind, ModulationMode mode, int slot, bool local, Token at)
{
    /// <summary>Coordinates of a formula, in the order of their slots.</summary>
    public static readonly IReadOnlyList<string> Coordinates = ["x", "y", "z", "r", "theta", "c", "v", "s", "u", "path"];

    private readonly Dictionary<string, Argument> _values = new(StringComparer.Ordinal);

    public ShapingKind Kind { get; } = kind;

    public ModulationMode Mode { get; } = mode;

    /// <summary>Slot of the first coordinate.</summary>
    public int Slot { get; } = slot;

    public bool Local { get; } = local;

    public Token At { get; } = at;

    /// <summary>True if positions are radius, angle and height.</summary>
    public bool IsCylindrical { get; set; }

    /// <summary>True if a formula reads coordinates of the other system.</summary>
    public bool NeedsBoth { get; set; }

    public Argument? this[string name] => _values.TryGetValue(name, out var value) ? value : null;

    public void Add(string name, Argument value) => _values.Add(name, value);

    public bool Has(params string[] names) => names.Any(_values.ContainsKey);

    /// <summary>The names that a header may set.</summary>
    public static IReadOnlyList<string> Names(ShapingKind kind) => kind switch
    {
        ShapingKind.Deform => ["x", "y", "z", "r", "theta", "c", "v", "tolerance"],
        ShapingKind.Modulate => ["field", "low", "high", "mask", "resolution"],
        ShapingKind.GapBead => ["min_gap", "max_gap", "width", "bed"],
        _ => ["min_layer_time", "speed_by_length", "min_speed", "max_segment_rate"],
    };

    /// <summary>The coordinates that its formulas can use.</summary>
    public static IEnumerable<string> Visible(ShapingKind kind) => kind switch
    {
        ShapingKind.Deform => Coordinates.Take(7),
        ShapingKind.Modulate => Coordinates.Take(5).Concat(Coordinates.Skip(7)),
        _ => [],
    };
}
