namespace Caterpillar.Display;

/// <summary>The value that the colors of an image show.</summary>
public enum ColorBy
{
    /// <summary>The role of the extrusion.</summary>
    Role,

    /// <summary>The height, Z.</summary>
    Height,

    /// <summary>The speed of the move.</summary>
    Speed,

    /// <summary>The number of the layer.</summary>
    Layer,

    /// <summary>The position in the print order.</summary>
    Progress,
}

/// <summary>Options of an image.</summary>
public sealed record ToolpathImageOptions
{
    /// <summary>Pixels.</summary>
    public int Width { get; init; } = 960;

    /// <summary>Pixels.</summary>
    public int Height { get; init; } = 720;

    /// <summary>The view. The part fills the image.</summary>
    public View View { get; init; } = View.ThreeQuarter;

    /// <summary>The part of the bed that fills the image instead, mm; its Z does not matter. Empty = all that is drawn.</summary>
    public Bounds Region { get; init; }

    /// <summary>The value that the colors of extrusions show.</summary>
    public ColorBy ColorBy { get; init; } = ColorBy.Role;

    /// <summary>Draw travel moves as thin lines.</summary>
    public bool Travel { get; init; }

    /// <summary>Draw the moves at the lowest height of the head as lines, for pens and lasers.</summary>
    public bool Strokes { get; init; }

    /// <summary>The moves to draw, for example some layers. All by default.</summary>
    public MoveFilter Filter { get; init; } = new();

    /// <summary>Memory limit for drawing.</summary>
    public MemoryLimit Memory { get; init; } = MemoryLimit.Default;
}

/// <summary>Draws a toolpath as shaded extrusions, seen from any side.</summary>
public static class ToolpathImage
{
    // Width of extrusions with unknown area, mm.
    private const double DefaultWidth = 0.4;

    /// <summary>The background color.</summary>
    public static Rgb Background { get; } = new(250, 250, 248);

    /// <summary>An image of the toolpath. Empty if the toolpath prints nothing.</summary>
    /// <exception cref="DiagnosticException">The image needs more memory than the limit.</exception>
    public static RasterImage Draw(Toolpath toolpath, ToolpathImageOptions? options = null, IProgress<double>? progress = null,
        CancellationToken cancel = default)
    {
        if (toolpath is null) throw new ArgumentNullException(nameof(toolpath));
        options ??= new ToolpathImageOptions();
        // Four points of color and depth for each point of the image.
        options.Memory.Check(40.0 * options.Width * options.Height, $"An image of {NumberFormatter.Format(options.Width)} × "
            + $"{NumberFormatter.Format(options.Height)} pixels");
        var canvas = new ExtrusionCanvas(options.Width * 2, options.Height * 2, Background, options.View);
        var floor = options.Strokes ? Lowest(toolpath) : double.NegativeInfinity;
        var ranges = Ranges(toolpath, options, floor);
        if (ranges.Box.IsEmpty) return canvas.Finish();
        var (region, box) = (options.Region, ranges.Box);
        canvas.Fit(region.IsEmpty ? box : new Bounds(region.Min.WithZ(box.Min.Z), region.Max.WithZ(box.Max.Z)));
        foreach (var move in toolpath.Moves())
        {
            if ((move.Index & 0xFFFF) == 0)
            {
                cancel.ThrowIfCancellationRequested();
                progress?.Report((double)move.Index / toolpath.Count);
            }
            if (!IsShown(toolpath, move, options, floor)) continue;
            var length = move.Length;
            if (length == 0)
            {
                if (Blob.Of(toolpath, move) is { } blob)
                    canvas.Extrusion(blob.Tip, blob.Tip, blob.Width, blob.Height, ColorOf(toolpath, move, options.ColorBy, ranges));
                continue;
            }
            var print = IsExtrusion(move, floor);
            var (width, height) = print ? SizeOf(toolpath, move, DefaultWidth) : (0, 0);
            var color = print ? ColorOf(toolpath, move, options.ColorBy, ranges) : Palette.Travel;
            var chords = move.Arc is { } arc ? arc.ChordCount(move.Start, Math.Max(0.02, arc.Radius(move.Start) * 1e-5)) : 1;
            var last = move.Start;
            for (var i = 1; i <= chords; i++)
            {
                if ((i & 0xFF) == 2) cancel.ThrowIfCancellationRequested();
                var next = move.PointAt((double)i / chords);
                canvas.Extrusion(last, next, width, height, color);
                last = next;
            }
        }
        return canvas.Finish();
    }

    /// <summary>Draws the toolpath and writes the image as a PNG file.</summary>
    /// <exception cref="IOException">The file cannot be written.</exception>
    /// <exception cref="OperationCanceledException">Canceled. No part of the file is left.</exception>
    public static void WriteFile(
        Toolpath toolpath, string path, ToolpathImageOptions? options = null, IProgress<double>? progress = null, CancellationToken cancel = default)
    {
        if (path is null) throw new ArgumentNullException(nameof(path));
        var png = PngWriter.ToBytes(Draw(toolpath, options, progress, cancel));
        using var file = new AtomicFile(path);
        file.Stream.Write(png, 0, png.Length);
        file.Commit();
    }

    // A stroke is at the lowest height from end to end.
    private static bool IsExtrusion(Move move, double floor)
        => move.Kind == MoveKind.Print || (move.Kind == MoveKind.Travel && Math.Max(move.Start.Z, move.End.Z) <= floor + 1e-6);

    private static double Lowest(Toolpath toolpath)
    {
        var lowest = double.PositiveInfinity;
        foreach (var move in toolpath.Moves())
        {
            // The move from the unknown start of a file draws nothing.
            if (move.Index > 0 && move.Start.Z == move.End.Z && move.Length > 0) lowest = Math.Min(lowest, move.End.Z);
        }
        return lowest;
    }

    private static bool IsShown(Toolpath toolpath, Move move, ToolpathImageOptions options, double floor)
        => (((IsExtrusion(move, floor) || move.Kind == MoveKind.Prime) && move.Role != Role.Purge)
            || (options.Travel && move.Kind is MoveKind.Travel or MoveKind.Wipe or MoveKind.MovingDeretract))
            && options.Filter.Matches(toolpath, move);

    private static ColorRanges Ranges(Toolpath toolpath, ToolpathImageOptions options, double floor)
    {
        var box = Bounds.Empty;
        double slow = double.MaxValue, fast = 0;
        foreach (var move in toolpath.Moves())
        {
            if (!IsShown(toolpath, move, options, floor)) continue;
            if (Blob.Of(toolpath, move) is { } blob) box = box.Include(BoundsOf(blob));
            if (!IsExtrusion(move, floor)) continue;
            box = box.Include(move.Bounds);
            slow = Math.Min(slow, move.Speed);
            fast = Math.Max(fast, move.Speed);
        }
        var layers = toolpath.NumbersOfLayers();
        return layers.Count == 0 ? new ColorRanges(box, slow, fast, 0, 0) : new ColorRanges(box, slow, fast, layers[0], layers[layers.Count - 1]);
    }

    private static Bounds BoundsOf(Blob blob)
    {
        var half = new Vec3(blob.Width / 2, blob.Width / 2, 0);
        return new Bounds(blob.Tip - half - new Vec3(0, 0, blob.Height), blob.Tip + half);
    }

    private static Rgb ColorOf(Toolpath toolpath, Move move, ColorBy by, ColorRanges ranges) => by switch
    {
        ColorBy.Role => Palette.Of(move.Role),
        ColorBy.Height => Palette.At((move.End.Z - ranges.Box.Min.Z) / Math.Max(ranges.Box.Size.Z, 1e-9)),
        ColorBy.Speed => Palette.At((move.Speed - ranges.Slow) / Math.Max(ranges.Fast - ranges.Slow, 1e-9)),
        ColorBy.Layer => Palette.At(((toolpath.NumberOfLayer(move) ?? 0) - ranges.FirstLayer) / Math.Max(ranges.LastLayer - ranges.FirstLayer, 1.0)),
        _ => Palette.At(move.Index / Math.Max(toolpath.Count - 1.0, 1)),
    };

    // A bead with round sides is as wide as slicers count it; of unknown height, or in the air, it is round.
    private static (double Width, double Height) SizeOf(Toolpath toolpath, Move move, double unknown)
    {
        if (toolpath.BeadOf(move) is not { Area: > 0 } bead) return (unknown, unknown);
        var width = bead.Width(BeadShape.Stadium);
        return (width, bead.Height > 0 ? Math.Min(width, bead.Height) : width);
    }

    private readonly record struct ColorRanges(Bounds Box, double Slow, double Fast, int FirstLayer, int LastLayer);
}
