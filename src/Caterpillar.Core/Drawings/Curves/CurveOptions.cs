using Caterpillar.Basics;
using Caterpillar.Geometry;
using Caterpillar.Machines;
using Caterpillar.Toolpaths;

namespace Caterpillar.Drawings;

/// <summary>Which user curves planning may reorder.</summary>
public enum CurveSorting : byte
{
    /// <summary>None: they are printed in the given order.</summary>
    None,

    /// <summary>Those of the same layer; layers keep the order in which they first appear.</summary>
    WithinLayers,

    /// <summary>All of them, for rules that order by layer or height themselves.</summary>
    All,
}

/// <summary>How user curves become paths, and the settings of curves without their own.</summary>
public sealed record CurveOptions
{
    /// <summary>Width of the extrusion, mm.</summary>
    public double Width { get; init; } = 0.45;

    /// <summary>Height of the extrusion, mm.</summary>
    public double Height { get; init; } = 0.2;

    /// <summary>Scales the area from width × height (the flow of the material comes on top).</summary>
    public double Multiplier { get; init; } = 1;

    /// <summary>mm/s; 0 for the speed of the print settings.</summary>
    public double Speed { get; init; }

    /// <summary>Cross-section for width × height; the rectangle is that of the Caterpillar paper.</summary>
    public BeadShape Shape { get; init; } = BeadShape.Rectangle;

    /// <summary>True draws all curves without extrusion: pen, brush, bare hot tool.</summary>
    public bool Strokes { get; init; }

    /// <summary>Division of curved parts; linear parts keep only their end points.</summary>
    public SubdivisionOptions Subdivision { get; init; } = SubdivisionOptions.ByDistance(1);

    /// <summary>Where area or speed change along a curve, segments are split so that from one to the next they change by no more than this fraction.</summary>
    public double RampStep { get; init; } = 0.1;

    /// <summary>Values that vary along a curve hold from their point to the next one, instead of varying linearly.</summary>
    public bool Steps { get; init; }

    /// <summary>Above 0, every point of the curves becomes a dot of this volume, mm³, and nothing is drawn between them.</summary>
    public double Dots { get; init; }

    /// <summary>Speed of E for dots, mm/s.</summary>
    public double DotSpeed { get; init; } = 2;

    /// <summary>Tolerance in mm of arcs fitted to the result; 0 for none.</summary>
    public double FitArcs { get; init; }

    /// <summary>Paths whose ends are closer than this, in mm, are joined if everything else about them is equal; 0 for none.</summary>
    public double MergeTolerance { get; init; }

    /// <summary>What planning may sort; by default curves are printed in their order.</summary>
    public CurveSorting Sorting { get; init; }

    /// <summary>How much memory the points may take until they are written; more is the error <see cref="MemoryLimit.Code"/>.</summary>
    public MemoryLimit Memory { get; init; } = MemoryLimit.Default;

    /// <summary>The settings of a profile: width, height, shape and subdivision distance.</summary>
    public static CurveOptions From(PrintSettings settings)
    {
        if (settings is null) throw new ArgumentNullException(nameof(settings));
        return new CurveOptions
        {
            Width = settings.LineWidth,
            Height = settings.LayerHeight,
            Shape = settings.BeadShape,
            Subdivision = SubdivisionOptions.ByDistance(settings.SubdivisionDistance),
        };
    }
}
