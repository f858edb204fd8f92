namespace Caterpillar.Toolpaths;

/// <summary>How the machine pauses a print.</summary>
public sealed record Pause
{
    /// <summary>Only the pause command, without moves.</summary>
    public static Pause Plain { get; } = new();

    /// <summary>Clearance above everything printed so far, mm. 0 = off: the head does not move or retract.</summary>
    public double Lift { get; init; }

    /// <summary>Maximum height of the nozzle, mm.</summary>
    public double MaxHeight { get; init; } = double.PositiveInfinity;

    /// <summary>Park position of the head, mm. Null = the corner of the print with minimum X and Y.</summary>
    public Vec3? Park { get; init; }

    /// <summary>Retraction length, mm of filament.</summary>
    public double Retraction { get; init; }

    /// <summary>Extra length after deretraction, before printing resumes, mm of filament.</summary>
    public double Prime { get; init; }

    /// <summary>Cross-section of the filament, mm².</summary>
    public double FilamentArea { get; init; } = 1;

    /// <summary>Travel speed to the park position and back, mm/s.</summary>
    public double TravelSpeed { get; init; } = 100;

    /// <summary>Speed of Z moves, mm/s.</summary>
    public double ZHopSpeed { get; init; } = 10;

    /// <summary>Retraction speed, mm/s.</summary>
    public double RetractionSpeed { get; init; } = 35;

    /// <summary>The pause command. Empty = the pause command of the G-code flavor.</summary>
    public string Command { get; init; } = "";
}
