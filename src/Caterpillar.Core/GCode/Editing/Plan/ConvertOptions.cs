using Caterpillar.Flavors;

namespace Caterpillar.GCode;

/// <summary>What a file is converted to. Null keeps what the file has.</summary>
public sealed record ConvertOptions
{
    /// <summary>The firmware to write for; null for that of the file.</summary>
    public FlavorRules? Flavor { get; init; }

    /// <summary>Relative E (true) or absolute E (false).</summary>
    public bool? RelativeE { get; init; }

    /// <summary>E in mm³ (true) or in mm of filament (false); needs the diameter of the filament.</summary>
    public bool? Volumetric { get; init; }

    /// <summary>Diameter of the filament, mm; where it is null, what the file says.</summary>
    public double? FilamentDiameter { get; init; }

    /// <summary>Arcs become chords. They also do where the target has no arcs.</summary>
    public bool ExpandArcs { get; init; }

    /// <summary>Largest distance of a chord from its arc, mm.</summary>
    public double ChordTolerance { get; init; } = 0.01;

    /// <summary>Inches become millimeters. They also do where the target has no inches.</summary>
    public bool Millimeters { get; init; }

    /// <summary>Retraction in the unit of E that stands for G10 and G11 where the target has none, and its speed in mm/s; 0 leaves them out.</summary>
    public double RetractionLength { get; init; }

    /// <summary>Speed of retractions that replace G10 and G11, mm/s.</summary>
    public double RetractionSpeed { get; init; } = 35;

    /// <summary>
    /// The most decimals of X, Y and Z, of E and of F; null keeps those of the file. What rounding leaves of E is carried over to the next line.
    /// </summary>
    public int? DecimalsXyz { get; init; }

    /// <summary>Decimals of E; null for as many as the file has.</summary>
    public int? DecimalsE { get; init; }

    /// <summary>Decimals of F; null for as many as the file has.</summary>
    public int? DecimalsF { get; init; }

    /// <summary>Threads; 0 for all cores. The result does not depend on it.</summary>
    public int Threads { get; init; }

    /// <summary>For comparison: every line takes the general path.</summary>
    internal bool GeneralPath { get; init; }
}
