namespace Caterpillar.Slicing;

/// <summary>The place of the purge tower: on the bed, and clear of models, supports, skirt, brim and raft.</summary>
internal static class TowerPlace
{
    // mm, beyond everything that is printed around the models.
    private const double Clearance = 3;

    // mm; what is reserved before the depth is known.
    private const double UsualDepth = 25;

    /// <summary>The tower of a depth: where the settings place it, or as near as possible to the middle of the bed.</summary>
    /// <exception cref="DiagnosticException">There is no room.</exception>
    public static Bounds Find(double depth, Footprint[] obstacles, PrintSettings settings, Printer printer)
    {
        var brim = new Vec3(settings.PurgeTowerBrimWidth, settings.PurgeTowerBrimWidth);
        var search = new PlaceSearch(printer, new ArrangeOptions { Spacing = Distance(settings) }, default) { Others = obstacles };
        var size = new Vec3(settings.PurgeTowerWidth, depth);
        var tower = Footprint.Of(new Bounds(-brim, size + brim));
        var wanted = settings.PurgeTowerPlace.Count > 0;
        var place = wanted ? search.At(tower, settings.PurgeTowerPlace[0] + size * 0.5) : search.FromTheMiddle([tower], [0])[0];
        if (place is not null) return new Bounds(place.Box.Min + brim, place.Box.Min + brim + size);
        throw Problem($"There is no room for the purge tower of {NumberFormatter.Format(size.X, 1)} × {NumberFormatter.Format(size.Y, 1)} mm "
            + (wanted ? "at purge_tower_place_mm. Move it, or the models." : "beside the models. Move them, or change purge_tower_width_mm."));
    }

    /// <summary>The printer without the part of the bed that a tower takes, which models must leave free.</summary>
    public static Printer Reserve(Printer printer, PrintSettings settings)
    {
        if (!settings.PurgeTower || printer.ToolCount == 1) return printer;
        var around = new Vec3(1, 1) * (settings.PurgeTowerBrimWidth + Distance(settings));
        var tower = Footprint.Of(new Bounds(-around, new Vec3(settings.PurgeTowerWidth, UsualDepth) + around));
        var search = new PlaceSearch(printer, new ArrangeOptions(), default);
        var wanted = settings.PurgeTowerPlace.Count > 0;
        var place = wanted ? tower.Moved(settings.PurgeTowerPlace[0].X, settings.PurgeTowerPlace[0].Y) : search.InRows([tower], [0])[0];
        return place is null ? printer : printer with { ExcludedAreas = new(printer.ExcludedAreas.Append(place.Box)) };
    }

    /// <summary>An error that leaves no tower.</summary>
    public static DiagnosticException Problem(string message) => new([new Diagnostic(Severity.Error, "slice.purge_tower", message)]);

    private static double Distance(PrintSettings settings)
        => Clearance + (settings.BrimWidth > 0 ? settings.BrimGap + settings.BrimWidth : 0)
            + (settings.SkirtLoops > 0 ? settings.SkirtDistance + settings.SkirtLoops * settings.LineWidth : 0);
}
