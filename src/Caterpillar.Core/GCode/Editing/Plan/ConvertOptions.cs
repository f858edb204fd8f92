namespace Caterpillar.GCode;

/// <summary>Target of a conversion. Null = no change.</summary>
public sealed record ConvertOptions
{
    /// <summary>G-code flavor of the output. Null = flavor of the file.</summary>
    public FlavorRules? Flavor { get; init; }

    /// <summary>Relative E (true) or absolute E (false).</summary>
    public bool? RelativeE { get; init; }

    /// <summary>E in mm³ (true) or in mm of filament (false). Needs the filament diameter.</summary>
    public bool? Volumetric { get; init; }

    /// <summary>Filament diameter, mm. Null = diameter that the file states.</summary>
    public double? FilamentDiameter { get; init; }

    /// <summary>Convert arcs to chords. Always on if the target has no arcs.</summary>
    public bool ExpandArcs { get; init; }

    /// <summary>Maximum deviation of chords from arcs, mm.</summary>
    public double ChordTolerance { get; init; } = 0.01;

    /// <summary>Convert inches to millimeters. Always on if the target has no inches.</summary>
    public bool Millimeters { get; init; }

    /// <summary>Retraction length, in the unit of E, that replaces G10 and G11 if the target has no firmware retraction. 0 = off.</summary>
    public double RetractionLength { get; init; }

    /// <summary>Speed of retractions that replace G10 and G11, mm/s.</summary>
    public double RetractionSpeed { get; init; } = 35;

    /// <summary>Maximum decimals of X, Y and Z. Null = decimals of the file.</summary>
    public int? DecimalsXyz { get; init; }

    /// <summary>Maximum decimals of E. Null = decimals of the file. The next line compensates the rounding.</summary>
    public int? DecimalsE { get; init; }

    /// <summary>Maximum decimals of F. Null = decimals of the file.</summary>
    public int? DecimalsF { get; init; }

    /// <summary>Number of threads. 0 = all cores. The result does not depend on it.</summary>
    public int Threads { get; init; }
}
