namespace Caterpillar.Slicing;

/// <summary>
/// Parallel lines that close an area. Rows are spread evenly between the sides of each island, the first and the last along them; what they miss at steps and
/// along holes gets extrusions of its own. Also the rows of <see cref="InfillPattern.Monotonic"/>, swept from one side.
/// </summary>
internal sealed class SolidRows
{
    // Rows along an edge lie this far inside it, mm: more than the grid of regions, less than anything that is printed.
    private const double Inside = 5e-5;

    // Share of a spacing by which rows may lie farther apart before there is one more: all of them together, or each where nothing is seen, up to the most
    // that all of them may then lie farther apart.
    private const double Slack = 0.1;
    private const double MostSlack = 0.7;

    // The thinnest line, in spacings.
    private const double Thinnest = 0.3;

    private readonly BoundaryLinks _links = new();
    private readonly RowGaps _gaps = new();
    private readonly List<InfillLine> _lines = [];
    private readonly List<(int Row, double From, double To)> _spans = [];

    /// <summary>The rows of all islands, one island after the other.</summary>
    public List<InfillLine> Fill(InfillRequest request, double longestLink)
    {
        var result = new List<InfillLine>();
        foreach (var island in request.Area.Islands) Fill(request, island, longestLink, result);
        return result;
    }

    private void Fill(InfillRequest request, Region island, double longestLink, List<InfillLine> result)
    {
        var frame = new PatternFrame(island, request.Angle);
        var (first, spacing, rows) = Spread(request, frame);
        _lines.Clear();
        _spans.Clear();
        foreach (var hatch in island.HatchLines(request.Angle, spacing, first))
        {
            double from = frame.U(hatch.From), to = frame.U(hatch.To);
            if (to - from <= 0) continue;
            double[]? flow = null;
            if (request.Solid)
            {
                var share = Territory(request, frame, hatch.Row, spacing, rows) / request.Spacing;
                if (Math.Abs(share - 1) > 1e-9) flow = [share];
            }
            _lines.Add(new InfillLine([hatch.From.WithZ(request.Z), hatch.To.WithZ(request.Z)], false, flow));
            _spans.Add((hatch.Row, from, to));
        }
        var limit = request.Linked ? (request.Hidden ? RowGaps.ShortestHidden : longestLink) * request.Spacing : -1;
        var width = request.Solid && !request.Hidden ? request.Spacing : 0;
        if (request.Pattern == InfillPattern.Monotonic) result.AddRange(_links.Sweep(island, _lines, _spans, limit, width, request.Early));
        else if (request.Linked) result.AddRange(_links.Join(island, _lines, limit, width, request.Early));
        else result.AddRange(_lines);
        if (request.Solid && rows > 0) _gaps.Add(request, island, frame, first, spacing, rows, result);
    }

    // Half of what lies between a row and its neighbors; at the edge half an extrusion.
    private static double Territory(InfillRequest request, in PatternFrame frame, int row, double spacing, int rows)
    {
        if (rows == 0) return Math.Max(Thinnest * request.Spacing, request.Spacing + frame.MaxV - frame.MinV - 2 * request.Overlap);
        return row == 0 || row == rows ? (request.Spacing + spacing) / 2 : spacing;
    }

    // Where row 0 is, how far apart rows are, and the number of the last.
    private static (double First, double Spacing, int Rows) Spread(InfillRequest request, in PatternFrame frame)
    {
        if (!request.Solid) return (0, request.Spacing, int.MaxValue);
        var inside = Inside + request.Overlap;
        var height = frame.MaxV - frame.MinV - 2 * inside;
        var rows = (int)(height / request.Spacing);
        var slack = request.Hidden ? Math.Min(Slack * Math.Max(rows, 1), MostSlack) : Slack;
        if (height > (rows + slack) * request.Spacing) rows++;
        return rows < 1
            ? ((frame.MinV + frame.MaxV) / 2, Math.Max(height, request.Spacing), 0)
            : (frame.MinV + inside, height / rows, rows);
    }
}
