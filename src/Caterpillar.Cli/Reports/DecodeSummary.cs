namespace Caterpillar.Cli;

/// <summary>Summary of a decoded file as text.</summary>
internal static class DecodeSummary
{
    public static void Write(TextWriter text, DecodedGCode decoding, DecodeReport report)
    {
        text.WriteLine($"{report.File}: {decoding.Flavor.Title}" + (decoding.Evidence.Count > 0 ? " (" + string.Join(" ", decoding.Evidence) + ")" : ""));
        var moves = decoding.Toolpath;
        var unit = moves.VolumePerE(0) == 1 ? "mm³" : "mm";
        var rows = new[]
        {
            ["  Printed", $"{Mm(report.PrintLength)} in {Figures.Count(report.PrintSegments + report.PrintArcs, "move")}, "
                + Figures.Count(moves.CountLayers(), "layer")],
            ["  Traveled", $"{Mm(report.TravelLength)} in {Figures.Count(report.TravelSegments + report.TravelArcs, "move")}, "
                + Figures.Count(report.Retractions + report.FirmwareRetractions, "retraction")],
            ["  Extruded", report.HasAmounts ? $"{Number(report.EUsed)} {unit} of E, net {Number(report.ENet)} {unit}" : "no E"],
            ["  Printed box", Box(report.PrintBounds)],
            new[] { "  All moves", Box(report.AllBounds) },
        };
        string[][] images = report.Thumbnails.Count == 0 ? [] : [["  Images", string.Join(", ", report.Thumbnails)]];
        var names = report.Setup.Take(3).Select(p => p.Key.Split('_')[0] + " " + p.Value);
        string[][] setup = report.Setup.Count == 0 ? [] : [["  Setup", string.Join(", ", names)]];
        TextTable.Write(text, [.. rows, .. Roles(moves), .. images, .. setup]);
        if (decoding.Ignored.Count > 0)
        {
            var ignored = decoding.Ignored.OrderByDescending(p => p.Value).ThenBy(p => p.Key, System.StringComparer.Ordinal).ToArray();
            text.WriteLine("  Ignored: " + string.Join(", ", ignored.Take(12).Select(p => $"{p.Key} ×{NumberFormatter.Format(p.Value)}"))
                + (ignored.Length > 12 ? ", …" : ""));
        }
    }

    // Length of each role, if the file has roles, and the width that follows from its volume.
    private static IEnumerable<string[]> Roles(Toolpath toolpath)
    {
        var totals = RoleTotals.Of(toolpath);
        if (totals.All(t => t.Role == Role.Unspecified)) yield break;
        foreach (var total in totals)
        {
            var extrusion = total is { Width: { } width, Area: > 0 and var area } ? $", {Number(width)} mm wide, {Number(area)} mm² on average" : "";
            yield return ["  " + Words.Spaced(total.Role.ToString()), Mm(total.Length) + extrusion];
        }
    }

    private static string Box(Bounds box) => box.IsEmpty ? "none" : $"{Point(box.Min)} to {Point(box.Max)} mm";

    private static string Point(Vec3 p) => $"{Number(p.X)}, {Number(p.Y)}, {Number(p.Z)}";

    private static string Mm(double value) => Number(value) + " mm";

    private static string Number(double value) => NumberFormatter.Format(value, 3);
}
