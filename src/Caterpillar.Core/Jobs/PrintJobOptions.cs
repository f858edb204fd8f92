using Caterpillar.Basics;
using Caterpillar.Geometry;
using Caterpillar.Planning;
using Caterpillar.Slicing;
using Caterpillar.Toolpaths;

namespace Caterpillar.Jobs;

/// <summary>How a print is made beyond its printer, material and settings.</summary>
public sealed record PrintJobOptions
{
    /// <summary>Degree of parallelism, 0 for all cores. It does not change the result.</summary>
    public int Threads { get; init; }

    /// <summary>How much memory each stage may take; more is the error <see cref="MemoryLimit.Code"/>.</summary>
    public MemoryLimit Memory { get; init; } = MemoryLimit.Default;

    /// <summary>What planning may add to a drawing.</summary>
    public PlanPolicy Policy { get; init; }

    /// <summary>How paths are sorted inside their groups, where the settings sort them.</summary>
    public SortRule Sort { get; init; } = SortRule.Tour;

    /// <summary>An object on the bed that is printed on; heights above the bed become heights above its surface. Null for the bed alone.</summary>
    public TriMesh? Onto { get; init; }

    /// <summary>How much the first extrusions are pressed onto the object, mm.</summary>
    public double Squeeze { get; init; }

    /// <summary>What lies beyond a surface or is too steep is left out; without this it is an error.</summary>
    public bool Partial { get; init; }

    /// <summary>How far the tool tilts along the normals of curved layers; null where it stays upright.</summary>
    public ToolTilt? Tilt { get; init; }

    /// <summary>
    /// Gives the lines that take the place of the infill's pattern in a layer, from the height of its top (<see cref="SliceOptions.InfillLines"/>);
    /// null for the pattern.
    /// </summary>
    public Func<double, IReadOnlyList<Polyline>>? InfillLines { get; init; }

    /// <summary>Coordinates that go to other axis words, applied to the planned moves in this order.</summary>
    public IReadOnlyList<AxisMapping> Mappings { get; init; } = [];

    internal PlanOptions Planning => new() { Policy = Policy, Sort = new SortOptions(Sort), Memory = Memory };
}
