namespace Caterpillar.Slicing;

/// <summary>Looks for a place for the purge tower: on the bed, and clear of models, supports, skirt, brim and raft.</summary>
internal static class TowerPlace
{
    // mm, beyond everything that is printed around the models.
    private const double Clearance = 3;

    // mm; a tall print needs more than the changes of one layer do.
    private const double LeastReserved = 20;

    /// <summary>The front left corner of the tower.</summary>
    /// <param name="depth">Depth of the tower, mm.</param>
    /// <param name="obstacles">Models and supports from above.</param>
    /// <param name="settings">The settings of the print.</param>
    /// <param name="printer">The printer.</param>
    /// <exception cref="DiagnosticException">There is no room.</exception>
    public static Vec3 Find(double depth, Footprint[] obstacles, PrintSettings settings, Printer printer)
    {
        var brim = new Vec3(settings.PurgeTowerBrimWidth, settings.PurgeTowerBrimWidth);
        var size = new Vec3(settings.PurgeTowerWidth, depth);
        var tower = Footprint.Of(new Bounds(-brim, size + brim));
        var distance = Distance(settings);
        var dimensions = $"{NumberFormatter.Format(size.X, 1)} × {NumberFormatter.Format(size.Y, 1)} mm";
        if (settings.PurgeTowerPosition.Count > 0)
        {
            var corner = settings.PurgeTowerPosition[0];
            var there = tower.Moved(corner.X, corner.Y);
            if (Array.TrueForAll(obstacles, o => there.IsApart(o, distance))) return corner;
            throw NoRoom($"The purge tower of {dimensions} at purge_tower_position_mm is less than {NumberFormatter.Format(distance, 1)} mm from a model.");
        }
        var search = new PlaceSearch(printer, new ArrangeOptions { Spacing = distance }, default);
        return search.Beside(tower, obstacles) is { } place ? place.Box.Min + brim
            : throw NoRoom($"There is no room for the purge tower of {dimensions} beside the models. Move them, or change purge_tower_width_mm.");
    }

    /// <summary>The printer without the part of the bed that a tower takes, which models must leave free.</summary>
    public static Printer Reserve(Printer printer, PrintSettings settings)
    {
        if (!settings.PurgeTower || printer.ToolCount == 1) return printer;
        // More than two tools in one layer are rare.
        var rows = new TowerRows(SliceRules.Of(settings, Math.Min(settings.LayerHeight, settings.FirstLayerHeight)), settings.PurgeTowerWidth);
        var depth = rows.DepthOf((Math.Min(printer.ToolCount, 3) - 1) * rows.CountFor(VolumeOf(settings, printer)));
        depth = Math.Max(LeastReserved, depth);
        var around = new Vec3(1, 1) * (settings.PurgeTowerBrimWidth + Distance(settings));
        var tower = Footprint.Of(new Bounds(-around, new Vec3(settings.PurgeTowerWidth, depth) + around));
        var place = settings.PurgeTowerPosition.Count > 0 ? tower.Moved(settings.PurgeTowerPosition[0].X, settings.PurgeTowerPosition[0].Y)
            : new PlaceSearch(printer, new ArrangeOptions(), default).InRows([tower], [0])[0];
        return place is null ? printer : printer with { ExcludedAreas = new(printer.ExcludedAreas.Append(place.Box)) };
    }

    /// <summary>Volume to purge at each tool change, mm³.</summary>
    public static double VolumeOf(PrintSettings settings, Printer printer)
        => settings.PurgeVolume > 0 ? settings.PurgeVolume : printer.SharedNozzle ? 140 : 15;

    private static double Distance(PrintSettings settings)
        => Clearance + (settings.BrimWidth > 0 ? settings.BrimGap + settings.BrimWidth : 0)
            + (settings.SkirtLoops > 0 ? settings.SkirtDistance + settings.SkirtLoops * settings.LineWidth : 0);

    private static DiagnosticException NoRoom(string message) => new([new Diagnostic(Severity.Error, "slice.purge_tower", message)]);
}
