using System;
using System.Collections.Generic;
using System.Linq;
using Caterpillar.Flavors;
using Caterpillar.Machines;

namespace Caterpillar.Tests.GCode;

/// <summary>What may differ between two toolpaths that are the same print, and why.</summary>
internal sealed record MoveTolerance
{
    /// <summary>One unit of the last printed decimal: the place, mm.</summary>
    public double Xyz { get; init; } = 1e-3;

    /// <summary>One unit of the last printed decimal of E. Sums over all moves keep within it, so that nothing drifts.</summary>
    public double E { get; init; } = 1e-5;

    /// <summary>mm/s; F is printed in mm/min.</summary>
    public double Speed { get; init; } = 1e-4;

    /// <summary>What one unit of E became, by tool: from mm of filament to mm³, for instance.</summary>
    public IReadOnlyList<double> EFactors { get; init; } = [1];

    public double Factor(int tool) => EFactors[Math.Min(tool, EFactors.Count - 1)];

    public double LargestFactor => Math.Max(EFactors.Max(), 1);

    /// <summary>Arcs may be chains of chords whose vertices lie on the arc (and whose chords keep this close to it, mm); 0 where arcs stay arcs.</summary>
    public double Chords { get; init; }

    /// <summary>Where a target has no G10 and G11: the length that stands for them, 0 where they are left out; null if they stay.</summary>
    public double? RetractionLength { get; init; }

    /// <summary>Numbers of layers and names of objects are equal; otherwise moves are in one layer here where they are in one layer there.</summary>
    public bool SameLayers { get; init; } = true;

    /// <summary>Only extrusions are asked for their layer: where a layer has lost all of its extrusions, its other moves belong to the next.</summary>
    public bool LayersOfExtrusions { get; init; }

    /// <summary>What primed or restored one tool may print with another; what it is for is then in the file only.</summary>
    public bool UnknownRoles { get; init; }

    /// <summary>How fast a fan can be told to turn: on and off only, or not at all.</summary>
    public FanScale Fan { get; init; }

    /// <summary>The target of a conversion, which does not have a command for every event; null = the same flavor.</summary>
    public FlavorRules? Target { get; init; }

    /// <summary>False where the target has no tools.</summary>
    public bool Tools { get; init; } = true;

    /// <summary>False where the target has no E at all: only the motion of the head is compared, and which moves print.</summary>
    public bool Amounts { get; init; } = true;
}
