using Caterpillar.Geometry;
using Caterpillar.Toolpaths;

namespace Caterpillar.Simulation;

/// <summary>What is printed in one role.</summary>
/// <param name="Role">The role.</param>
/// <param name="Time">Seconds of motion.</param>
/// <param name="Length">Path length of the head, mm.</param>
/// <param name="Volume">mm³; null where the factor of a tool is not known.</param>
public sealed record RoleTime(Role Role, double Time, double Length, double? Volume);

/// <summary>What one tool does.</summary>
/// <param name="Tool">Its number.</param>
/// <param name="Time">Seconds of motion.</param>
/// <param name="Filament">mm of filament that is deposited, also where E is a volume.</param>
/// <param name="Volume">mm³; null where its factor is not known.</param>
/// <param name="Mass">Grams; null as well.</param>
public sealed record ToolUse(int Tool, double Time, double Filament, double? Volume, double? Mass);

/// <summary>What one layer takes.</summary>
/// <param name="Layer">Index into the layers of the toolpath.</param>
/// <param name="Start">Seconds from the start of the print to its first move.</param>
/// <param name="Time">Seconds of its moves, waits before and between them included.</param>
/// <param name="Length">Path length of the head while printing, mm.</param>
/// <param name="Volume">mm³; null where the factor of a tool is not known.</param>
public sealed record LayerTime(int Layer, double Start, double Time, double Length, double? Volume);

/// <summary>Sums over a print in time. Lengths in mm, times in seconds.</summary>
public sealed record PrintStatistics
{
    /// <summary>Motion and waits.</summary>
    public double Duration { get; init; }

    /// <summary>Time in which the head stands still, s.</summary>
    public WaitTimes Waits { get; init; }

    /// <summary>Time of printing moves.</summary>
    public double PrintTime { get; init; }

    /// <summary>Time of moves of the head that print nothing.</summary>
    public double TravelTime { get; init; }

    /// <summary>Time of the extruder alone.</summary>
    public double ExtruderTime { get; init; }

    /// <summary>Length of printing moves, mm.</summary>
    public double PrintLength { get; init; }

    /// <summary>Length of all other moves, mm.</summary>
    public double TravelLength { get; init; }

    /// <summary>Retractions in place or in motion.</summary>
    public int Retractions { get; init; }

    /// <summary>Moves of the toolpath.</summary>
    public int Moves { get; init; }

    /// <summary>mm³ of material; null where the factor of a tool is not known.</summary>
    public double? Volume { get; init; }

    /// <summary>mm of filament that is deposited.</summary>
    public double Filament { get; init; }

    /// <summary>Grams, by the density of the material; null where the volume is not known.</summary>
    public double? Mass { get; init; }

    /// <summary>Price of the material in the currency of its profile; null where volume or price is not known.</summary>
    public double? Cost { get; init; }

    /// <summary>Greatest flow of an extrusion at the highest speed that it reaches, mm³/s; null where nothing is deposited or no factor is known.</summary>
    public double? GreatestFlow { get; init; }

    /// <summary>The move of the greatest flow, or −1.</summary>
    public int GreatestFlowMove { get; init; } = -1;

    /// <summary>Highest speed that the head reaches, mm/s.</summary>
    public double GreatestSpeed { get; init; }

    /// <summary>Box around what is printed, mm.</summary>
    public Bounds PrintBounds { get; init; }

    /// <summary>The roles that print, in their order.</summary>
    public IReadOnlyList<RoleTime> Roles { get; init; } = [];

    /// <summary>The tools that do anything, in their order.</summary>
    public IReadOnlyList<ToolUse> Tools { get; init; } = [];

    /// <summary>The layers of the toolpath that any move is in, in their order.</summary>
    public IReadOnlyList<LayerTime> Layers { get; init; } = [];

    /// <summary>The statistics of a timeline, by the material of its setup.</summary>
    public static PrintStatistics Of(Timeline timeline, System.Threading.CancellationToken cancel = default)
        => new StatisticsSums(timeline ?? throw new ArgumentNullException(nameof(timeline))).Run(cancel);
}
