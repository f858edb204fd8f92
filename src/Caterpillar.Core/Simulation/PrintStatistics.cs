namespace Caterpillar.Simulation;

/// <summary>Time and material of one role.</summary>
/// <param name="Role">The role.</param>
/// <param name="Time">Seconds of motion.</param>
/// <param name="Length">Path length of the head, mm.</param>
/// <param name="Volume">mm³; null if the filament diameter of a tool is unknown.</param>
public sealed record RoleTime(Role Role, double Time, double Length, double? Volume);

/// <summary>Time and material of one tool.</summary>
/// <param name="Tool">Its number.</param>
/// <param name="Time">Seconds of motion.</param>
/// <param name="Filament">Extruded filament, mm, also if E is a volume.</param>
/// <param name="Volume">mm³; null if its filament diameter is unknown.</param>
/// <param name="Mass">Grams; null if the volume is unknown.</param>
public sealed record ToolUse(int Tool, double Time, double Filament, double? Volume, double? Mass);

/// <summary>Time and material of one layer.</summary>
/// <param name="Layer">Index into the layers of the toolpath.</param>
/// <param name="Start">Seconds from the start of the print to its first move.</param>
/// <param name="Time">Seconds of its moves, with the waits before and between them.</param>
/// <param name="Length">Path length of the head while printing, mm.</param>
/// <param name="Volume">mm³; null if the filament diameter of a tool is unknown.</param>
public sealed record LayerTime(int Layer, double Start, double Time, double Length, double? Volume);

/// <summary>Totals of a print. Lengths in mm, times in seconds.</summary>
public sealed record PrintStatistics
{
    /// <summary>Print time, with waits.</summary>
    public double Duration { get; init; }

    /// <summary>Time in which the head waits.</summary>
    public WaitTimes Waits { get; init; }

    /// <summary>Time of printing moves.</summary>
    public double PrintTime { get; init; }

    /// <summary>Time of travel moves.</summary>
    public double TravelTime { get; init; }

    /// <summary>Time of extruder moves in place.</summary>
    public double ExtruderTime { get; init; }

    /// <summary>Length of printing moves, mm.</summary>
    public double PrintLength { get; init; }

    /// <summary>Length of all other moves, mm.</summary>
    public double TravelLength { get; init; }

    /// <summary>Number of retractions, in place or during a wipe.</summary>
    public int Retractions { get; init; }

    /// <summary>Number of moves.</summary>
    public int Moves { get; init; }

    /// <summary>Material, mm³; null if the filament diameter of a tool is unknown.</summary>
    public double? Volume { get; init; }

    /// <summary>Extruded filament, mm.</summary>
    public double Filament { get; init; }

    /// <summary>Mass from the density of the material, g; null if the volume is unknown.</summary>
    public double? Mass { get; init; }

    /// <summary>Cost of the material, in the currency of its profile; null if volume or price is unknown.</summary>
    public double? Cost { get; init; }

    /// <summary>Maximum volumetric flow of an extrusion, at its highest speed, mm³/s; null if nothing is extruded or the volume is unknown.</summary>
    public double? GreatestFlow { get; init; }

    /// <summary>The move with the maximum flow, or −1.</summary>
    public int GreatestFlowMove { get; init; } = -1;

    /// <summary>Maximum speed that the head reaches, mm/s.</summary>
    public double GreatestSpeed { get; init; }

    /// <summary>Bounding box of the extrusions, mm.</summary>
    public Bounds PrintBounds { get; init; }

    /// <summary>Roles with extrusions, in order.</summary>
    public IReadOnlyList<RoleTime> Roles { get; init; } = [];

    /// <summary>Tools in use, in order.</summary>
    public IReadOnlyList<ToolUse> Tools { get; init; } = [];

    /// <summary>Layers with moves, in order.</summary>
    public IReadOnlyList<LayerTime> Layers { get; init; } = [];

    /// <summary>Totals of a timeline, with the material of its setup.</summary>
    public static PrintStatistics Of(Timeline timeline, System.Threading.CancellationToken cancel = default)
    {
        if (timeline is null) throw new ArgumentNullException(nameof(timeline));
        var sums = new StatisticsSums(timeline.Toolpath, timeline.Setup);
        for (var block = 0; block < timeline.Toolpath.Blocks.Count; block++)
        {
            cancel.ThrowIfCancellationRequested();
            sums.Block(block, timeline.Motion);
        }
        return sums.ToStatistics(timeline.Duration, timeline.Waits);
    }

    /// <summary>Totals of a toolpath on the printer of a setup, with its material. Memory does not grow with the toolpath.</summary>
    public static PrintStatistics Of(
        Toolpath toolpath, PrintSetup setup, IProgress<double>? progress = null, System.Threading.CancellationToken cancel = default)
    {
        if (toolpath is null) throw new ArgumentNullException(nameof(toolpath));
        if (setup is null) throw new ArgumentNullException(nameof(setup));
        toolpath = setup.Printer.Turned(toolpath, cancel);
        var sums = new StatisticsSums(toolpath, setup);
        var planner = new MotionPlanner(toolpath, setup, finished: sums.Block);
        planner.Take(toolpath, progress, cancel);
        var plan = planner.End();
        return sums.ToStatistics(plan.Motion.TotalTime, plan.Waits);
    }
}
