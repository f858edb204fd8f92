namespace Caterpillar.Slicing;

/// <summary>Fills areas with extrusions. One thread at a time; keeps its arrays for the next area.</summary>
internal sealed class InfillFiller(RegionEngine engine)
{
    /// <summary>mm; a printer is slow in shorter moves.</summary>
    public const double ShortestSegment = 0.1;

    // Longest link along the boundary, in distances of lines.
    private const double LongestLink = 2;

    // How far, in mm, lines may leave the area where they follow its boundary: fine corners there cost moves and show nowhere.
    private const double Smoothing = 0.02;

    // How far lines may move where short segments are left away: mm, and mm² in one place.
    private const double ShortTolerance = 0.05;
    private const double ShortArea = 0.015;

    private readonly BoundaryLinks _links = new();
    private readonly LevelSet _levels = new();
    private readonly SolidRows _rows = new();

    /// <summary>
    /// How many families of lines share the length: lines of one family are spacing × families apart. A spacing measured between the lines of the pattern
    /// itself (the "density" of Caterpillar 2019) is divided by it to get <see cref="InfillRequest.Spacing"/>.
    /// </summary>
    public static int Families(InfillPattern pattern) => pattern switch
    {
        InfillPattern.Grid => 2,
        InfillPattern.Triangles or InfillPattern.Cubic => 3,
        _ => 1,
    };

    /// <summary>The extrusions in the order in which they are to be printed; only <see cref="InfillPattern.Monotonic"/> depends on that order.</summary>
    /// <exception cref="ArgumentException">Spacing, width or tolerance are not positive numbers, or what the pattern needs is missing.</exception>
    public IReadOnlyList<InfillLine> Fill(InfillRequest request)
    {
        Check(request.Spacing, nameof(request.Spacing));
        Check(request.Width, nameof(request.Width));
        Check(request.Tolerance, nameof(request.Tolerance));
        request = request with { Area = request.Area.Simplified(Smoothing, engine) };
        var result = new List<InfillLine>();
        if (request.Area.IsEmpty) return result;
        foreach (var line in request.Pattern == InfillPattern.Monotonic || (request.Pattern == InfillPattern.Lines && request.Solid)
            ? _rows.Fill(request, LongestLink)
            : Pattern(request))
        {
            // Shorter than wide, an extrusion is a blob.
            if (!request.Solid && line.IsShorterThan(request.Width)) continue;
            if (line.WithoutShort(ShortestSegment, ShortTolerance, ShortArea) is { } kept) result.Add(kept);
        }
        return result;
    }

    private List<InfillLine> Pattern(InfillRequest request)
    {
        var lines = new List<InfillLine>();
        var distance = request.Spacing * Families(request.Pattern);
        switch (request.Pattern)
        {
            case InfillPattern.Gyroid:
                Clip(request, GyroidPattern.Waves(request), lines);
                distance *= GyroidPattern.MeanLength / 2;
                break;
            case InfillPattern.Honeycomb:
                if (HoneycombPattern.Rows(request) is { } rows) Clip(request, rows, lines);
                else StraightPatterns.Add(request, lines);
                distance *= 4.0 / 3;
                break;
            case InfillPattern.Concentric:
                ConcentricPattern.Add(request, engine, lines);
                break;
            case InfillPattern.Hilbert:
                Clip(request, HilbertPattern.Curve(request), lines);
                break;
            case InfillPattern.Formula:
                Clip(request, _levels.Trace(request), lines);
                break;
            case InfillPattern.Curves or InfillPattern.Lightning:
                Clip(request, request.Curves ?? throw new ArgumentException("The curves are missing.", nameof(request)), lines);
                break;
            default:
                StraightPatterns.Add(request, lines);
                break;
        }
        var longest = request.LongestLink > 0 ? request.LongestLink : LongestLink * distance;
        return request.Linked ? _links.Join(request.Area, lines, longest, anchor: request.Anchor) : lines;
    }

    private static void Check(double value, string name)
    {
        if (!(value > 0) || double.IsInfinity(value)) throw new ArgumentException("The value must be positive.", name);
    }

    private static void Clip(InfillRequest request, IReadOnlyList<Polyline> curves, List<InfillLine> lines)
    {
        foreach (var piece in request.Area.ClipLines(curves))
        {
            var points = Array.ConvertAll(piece.Raw, p => p.WithZ(request.Z));
            lines.Add(new InfillLine(points, piece.IsClosed));
        }
    }
}
