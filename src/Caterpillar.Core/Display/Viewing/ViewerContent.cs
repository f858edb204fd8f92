using Caterpillar.Basics;
using Caterpillar.Geometry;
using Caterpillar.Machines;
using Caterpillar.Toolpaths;

namespace Caterpillar.Display;

/// <summary>What a viewer page shows: a toolpath, a model, or both. All but the title may be missing.</summary>
public sealed record ViewerContent(string Title)
{
    /// <summary>The moves to show.</summary>
    public Toolpath? Toolpath { get; init; }

    /// <summary>The G-code that the moves were read from, as text or packed with gzip; their sources are its lines.</summary>
    public byte[]? GCode { get; init; }

    /// <summary>Seconds from the start of the print until a move is over; the page has no times without it.</summary>
    public Func<int, double>? EndOf { get; init; }

    /// <summary>A sentence that says by which limits the times were found.</summary>
    public string Limits { get; init; } = "";

    /// <summary>The printer whose bed, volume and head are drawn.</summary>
    public Printer? Printer { get; init; }

    /// <summary>Shape of the extrusions, which determines their widths.</summary>
    public BeadShape Shape { get; init; } = BeadShape.Rectangle;

    /// <summary>Material in g per cm³; 0 if unknown.</summary>
    public double Density { get; init; }

    /// <summary>Findings to list; those with a move or a line lead to their place.</summary>
    public IReadOnlyList<Diagnostic> Findings { get; init; } = [];

    /// <summary>A mesh to show.</summary>
    public TriMesh? Model { get; init; }
}
