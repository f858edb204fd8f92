namespace Caterpillar.Drawings;

/// <summary>User curves that planning may reorder.</summary>
public enum CurveSorting : byte
{
    /// <summary>None. Curves are printed in the given order.</summary>
    None,

    /// <summary>Curves of the same layer. Layers keep the order of their first appearance.</summary>
    WithinLayers,

    /// <summary>All curves, for sorting rules that order by layer or height themselves.</summary>
    All,
}

/// <summary>Conversion of user curves to paths, and default settings for curves without their own.</summary>
public sealed record CurveOptions
{
    /// <summary>Width of the extrusion, mm.</summary>
    public double Width { get; init; } = 0.45;

    /// <summary>Height of the extrusion, mm.</summary>
    public double Height { get; init; } = 0.2;

    /// <summary>Flow ratio of width × height. The flow ratio of the material is applied in addition.</summary>
    public double Flow { get; init; } = 1;

    /// <summary>Print speed, mm/s; 0 = printing speed of the settings.</summary>
    public double Speed { get; init; }

    /// <summary>Bead shape for width × height. The Caterpillar paper uses the rectangle.</summary>
    public BeadShape Shape { get; init; } = BeadShape.Rectangle;

    /// <summary>Draw all curves without extrusion: pen, brush, bare hot tool.</summary>
    public bool Strokes { get; init; }

    /// <summary>Subdivision of curved parts. Linear parts keep only their end points.</summary>
    public SubdivisionOptions Subdivision { get; init; } = SubdivisionOptions.ByDistance(1);

    /// <summary>Values that vary along a curve stay constant from their point to the next, instead of varying linearly.</summary>
    public bool Steps { get; init; }

    /// <summary>Volume of the dots at every point of the curves, mm³; 0 = off. With dots, nothing is drawn between the points.</summary>
    public double Dots { get; init; }

    /// <summary>Filament speed for dots, mm/s.</summary>
    public double DotSpeed { get; init; } = 2;

    /// <summary>Tolerance of arcs fitted to the result, mm; 0 = no arc fitting.</summary>
    public double FitArcs { get; init; }

    /// <summary>Maximum distance between the ends of joined paths, mm; 0 = off. All other properties of joined paths must be equal.</summary>
    public double MergeTolerance { get; init; }

    /// <summary>Z at which a drawing is printed that is flat at Z 0, mm; 0 = as drawn.</summary>
    public double FlatHeight { get; init; }

    /// <summary>
    /// Number of layers to stack of a drawing that is flat at Z 0: the first is <see cref="FlatHeight"/> high, each other one <see cref="Height"/>. They
    /// replace the layers of the curves. 0 = as drawn.
    /// </summary>
    public int Layers { get; init; }

    /// <summary>Curves that planning may reorder. By default, curves are printed in their order.</summary>
    public CurveSorting Sorting { get; init; }

    /// <summary>Maximum memory of the points until they are written. More is the error <see cref="MemoryLimit.Code"/>.</summary>
    public MemoryLimit Memory { get; init; } = MemoryLimit.Default;

    /// <summary>Options for a print: <see cref="From"/> its settings, and flat drawings at the height of the first layer if the printer extrudes.</summary>
    public static CurveOptions For(PrintSetup setup)
    {
        if (setup is null) throw new ArgumentNullException(nameof(setup));
        return From(setup.Settings) with { FlatHeight = setup.Printer.ExtrusionUnit == ExtrusionUnit.None ? 0 : setup.Settings.FirstLayerHeight };
    }

    /// <summary>Width, height, shape and subdivision distance from the settings of a print.</summary>
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
