namespace Caterpillar.Slicing;

/// <summary>Patterns of straight lines. Rows have fixed positions in the world, so that each layer rests on the one below.</summary>
internal static class StraightPatterns
{
    private static readonly double Sqrt2 = Math.Sqrt(2);

    public static void Add(InfillRequest request, List<InfillLine> lines)
    {
        var spacing = request.Spacing * InfillFiller.Families(request.Pattern);
        switch (request.Pattern)
        {
            case InfillPattern.Grid:
                Family(request, 0, spacing, 0, lines);
                Family(request, 90, spacing, 0, lines);
                break;
            case InfillPattern.Triangles:
                for (var i = 0; i < 3; i++) Family(request, 60 * i, spacing, 0, lines);
                break;
            case InfillPattern.Cubic:
                // The planes of cubes on a corner have normals (√2 cos, √2 sin, 1) / √3, so their sections move by z / √2.
                for (var i = 0; i < 3; i++) Family(request, 120 * i, spacing, -request.Z / Sqrt2, lines);
                break;
            default:
                Family(request, 0, spacing, 0, lines);
                break;
        }
    }

    private static void Family(InfillRequest request, double turn, double spacing, double phase, List<InfillLine> lines)
    {
        foreach (var line in request.Area.HatchLines(request.Angle + turn, spacing, phase))
            lines.Add(new InfillLine([line.From.WithZ(request.Z), line.To.WithZ(request.Z)], false));
    }
}
