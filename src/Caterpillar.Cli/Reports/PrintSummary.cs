namespace Caterpillar.Cli;

/// <summary>Summary of a print in one line: layers, size, material, time.</summary>
internal static class PrintSummary
{
    public static string Of(PrintFigures print)
    {
        var parts = new List<string>();
        if (print.Layers > 0) parts.Add(Figures.Count(print.Layers, "layer"));
        if (print.Size is { } size) parts.Add(Size(size));
        parts.Add(print is { Printed: 0, E: 0 } ? "nothing printed" : Amount(print));
        if (print.Seconds is > 0 and var time) parts.Add("about " + Duration(time));
        return string.Join(", ", parts);
    }

    /// <summary>A number of bytes as text: <c>1.2 MB</c>.</summary>
    public static string Size(long bytes) => bytes == 1 ? "1 byte" : MemoryLimit.Text(bytes);

    /// <summary>Hours and minutes, or minutes and seconds.</summary>
    public static string Duration(double seconds)
    {
        if (!(seconds < 1e9)) return "more than 30 years";
        var whole = (long)Math.Round(seconds);
        var minutes = (long)Math.Round(seconds / 60);
        return whole < 60 ? $"{NumberFormatter.Format(whole)} s"
            : whole < 3600 ? $"{NumberFormatter.Format(whole / 60)} min {NumberFormatter.Format(whole % 60)} s"
            : $"{NumberFormatter.Format(minutes / 60)} h {NumberFormatter.Format(minutes % 60)} min";
    }

    private static string Size(Vec3 size) => $"{Number(size.X, 1)} × {Number(size.Y, 1)}{(size.Z >= 0.05 ? " × " + Number(size.Z, 1) : "")} mm";

    private static string Amount(PrintFigures print)
    {
        if (print.E == 0) return $"{Meters(print.Printed)} of pen lines";
        if (print.Volume is not > 0) return $"{Meters(print.Printed)} of extrusions, E {Number(print.E, 1)}";
        var mass = print.Mass is { } grams ? $" ({Grams(grams)})" : "";
        return print.Filament is { } filament ? $"{Meters(filament)} of filament{mass}" : $"{Number(print.Volume.Value / 1000, 2)} cm³{mass}";
    }

    private static string Meters(double mm) => mm < 1000 ? Number(mm, mm < 100 ? 1 : 0) + " mm" : Number(mm / 1000, mm < 10_000 ? 2 : 1) + " m";

    private static string Grams(double grams) => Figures.Short(grams >= 10 ? Math.Round(grams) : grams) + " g";

    private static string Number(double value, int decimals) => NumberFormatter.Format(value, decimals);
}
