using Caterpillar.Geometry;

namespace Caterpillar.Toolpaths;

/// <summary>How a print pauses. Lengths in mm, speeds in mm/s.</summary>
public sealed record Pause
{
    /// <summary>The command alone, on the spot.</summary>
    public static Pause Plain { get; } = new();

    /// <summary>Height above everything printed so far; 0 stays on the spot, and then nothing is parked or retracted.</summary>
    public double Lift { get; init; }

    /// <summary>The greatest height of the nozzle.</summary>
    public double MaxHeight { get; init; } = double.PositiveInfinity;

    /// <summary>Where the head waits; null for the corner with the least X and Y that the print reaches.</summary>
    public Vec3? Park { get; init; }

    /// <summary>Filament that is retracted, and what is extruded beyond it afterwards; of the cross-section <see cref="FilamentArea"/>, mm².</summary>
    public double Retraction { get; init; }

    /// <summary>Filament that is extruded beyond what was retracted, before printing goes on, mm.</summary>
    public double Prime { get; init; }

    /// <summary>Cross-section of the filament, mm².</summary>
    public double FilamentArea { get; init; } = 1;

    /// <summary>Speed to the place where the head waits and back, mm/s.</summary>
    public double TravelSpeed { get; init; } = 100;

    /// <summary>Speed up and down, mm/s.</summary>
    public double ZHopSpeed { get; init; } = 10;

    /// <summary>Speed of the filament, mm/s.</summary>
    public double RetractionSpeed { get; init; } = 35;

    /// <summary>The command, or empty for that of the flavor.</summary>
    public string Command { get; init; } = "";
}
