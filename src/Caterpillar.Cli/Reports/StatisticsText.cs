namespace Caterpillar.Cli;

/// <summary>Statistics of a print as tables, with a histogram of layer times.</summary>
internal static class StatisticsText
{
    private const int Bins = 10;
    private const int Width = 40;

    public static void Write(TextWriter text, PrintStatistics s, string limits)
    {
        TextTable.Write(text,
        [
            ["  Time", $"{Duration(s.Duration)} with the limits of {limits}"],
            ["  Printing", Duration(s.PrintTime)],
            ["  Traveling", Duration(s.TravelTime)],
            ["  Extruder only", $"{Duration(s.ExtruderTime)}, {Figures.Count(s.Retractions, "retraction")}"],
            .. Waits(s.Waits),
            ["  Material", Material(s)],
            .. Flow(s),
        ]);
        if (s.Roles.Count > 1 || s.Roles.Any(r => r.Role != Role.Unspecified)) Roles(text, s);
        if (s.Tools.Count > 1) Tools(text, s);
        if (s.Layers.Count > 1) Histogram(text, s);
    }

    /// <summary>A time in hours, minutes and seconds.</summary>
    public static string Duration(double seconds)
    {
        if (seconds < 60) return Number(seconds, 2) + " s";
        var whole = (long)Math.Round(seconds);
        var minutes = $"{NumberFormatter.Format(whole / 60 % 60)} min {NumberFormatter.Format(whole % 60)} s";
        return whole >= 3600 ? $"{NumberFormatter.Format(whole / 3600)} h {minutes}" : minutes;
    }

    private static IEnumerable<string[]> Waits(WaitTimes waits)
    {
        if (waits.Heating > 0) yield return ["  Heating", Duration(waits.Heating)];
        if (waits.Dwells > 0) yield return ["  Dwells", Duration(waits.Dwells)];
        if (waits.ToolChanges > 0) yield return ["  Tool changes", Duration(waits.ToolChanges)];
        if (waits.Homing > 0) yield return ["  Homing", Duration(waits.Homing)];
    }

    private static string Material(PrintStatistics s)
        => s.Filament == 0 ? "none" : $"{Number(s.Filament, 1)} mm of filament" + (s.Volume is { } volume ? $", {Number(volume / 1000, 2)} cm³" : "")
            + (s.Mass is { } mass ? $", {Number(mass, 2)} g" : "") + (s.Cost is { } cost ? $", costs {Number(cost, 2)}" : "");

    private static IEnumerable<string[]> Flow(PrintStatistics s)
    {
        if (s.GreatestFlow is { } flow) yield return ["  Maximum flow", $"{Number(flow, 2)} mm³/s in move {NumberFormatter.Format(s.GreatestFlowMove)}"];
        yield return ["  Maximum speed", $"{Number(s.GreatestSpeed, 1)} mm/s"];
    }

    private static void Roles(TextWriter text, PrintStatistics s)
    {
        text.WriteLine();
        string[][] rows = s.Roles.Select(r => new[]
        {
            "  " + Words.Spaced(r.Role.ToString()), Duration(r.Time), Percent(r.Time, s.Duration), Number(r.Length / 1000, 2) + " m",
            r.Volume is { } v ? Number(v / 1000, 2) + " cm³" : "–",
        }).ToArray();
        TextTable.Write(text, [["  Role", "time", "share", "length", "material"], .. rows]);
    }

    private static void Tools(TextWriter text, PrintStatistics s)
    {
        text.WriteLine();
        string[][] rows = s.Tools.Select(t => new[]
        {
            "  " + NumberFormatter.Format(t.Tool), Duration(t.Time), Number(t.Filament, 1) + " mm", t.Mass is { } m ? Number(m, 2) + " g" : "–",
        }).ToArray();
        TextTable.Write(text, [["  Tool", "time", "filament", "mass"], .. rows]);
    }

    // Number of layers by their time.
    private static void Histogram(TextWriter text, PrintStatistics s)
    {
        var times = s.Layers.Select(l => l.Time).ToArray();
        double least = times.Min(), most = times.Max();
        var counts = new int[most > least ? Bins : 1];
        foreach (var time in times) counts[Math.Min((int)((time - least) / (most - least) * counts.Length), counts.Length - 1)]++;
        var slow = s.Layers[Array.IndexOf(times, most)];
        text.WriteLine();
        var layers = $"  {NumberFormatter.Format(times.Length)} layers of {Duration(least)} to {Duration(most)}";
        text.WriteLine($"{layers}. The slowest starts after {Duration(slow.Start)}.");
        var rows = counts.Select((count, i) => new[]
        {
            "  " + Number(least + (most - least) * i / counts.Length, 1) + " s",
            NumberFormatter.Format(count),
            new string('█', (int)Math.Ceiling((double)count * Width / counts.Max())),
        }).ToArray();
        TextTable.Write(text, rows);
    }

    private static string Percent(double part, double whole) => whole > 0 ? Number(100 * part / whole, 1) + " %" : "–";

    private static string Number(double value, int decimals) => NumberFormatter.Format(value, decimals);
}
