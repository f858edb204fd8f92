namespace Caterpillar.Display;

/// <summary>The content of a viewer page: a toolpath, a model, or both. Only the title is required.</summary>
public sealed record ViewerContent(string Title)
{
    /// <summary>The moves to show.</summary>
    public Toolpath? Toolpath { get; init; }

    /// <summary>The G-code of the toolpath, as text or gzip. The sources of the moves are its lines.</summary>
    public byte[]? GCode { get; init; }

    /// <summary>End time of a move in seconds from the start of the print. Null = no times.</summary>
    public Func<int, double>? EndOf { get; init; }

    /// <summary>The motion limits from which the times were calculated, as text.</summary>
    public string Limits { get; init; } = "";

    /// <summary>The printer: its bed, build volume and print head are drawn.</summary>
    public Printer? Printer { get; init; }

    /// <summary>Shape of the extrusions, which determines their widths.</summary>
    public BeadShape Shape { get; init; } = BeadShape.Rectangle;

    /// <summary>Density of the material, g/cm³. 0 = unknown.</summary>
    public double Density { get; init; }

    /// <summary>Findings to list. Findings with a move or a line link to their place.</summary>
    public IReadOnlyList<Diagnostic> Findings { get; init; } = [];

    /// <summary>A mesh to show.</summary>
    public TriMesh? Model { get; init; }
}
