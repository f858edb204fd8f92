namespace Caterpillar.Machines;

/// <summary>Keys of print settings that hold for a whole print: one of several models cannot have a value of its own.</summary>
internal static class PrintWideKeys
{
    private static readonly IReadOnlyList<ProfileKey<PrintSettings>> All =
    [
        SettingsKeys.TravelSpeed, SettingsKeys.TravelLift, SettingsKeys.LiftMinTravel, SettingsKeys.Detour, SettingsKeys.Comb, TravelKeys.CombDetour,
        SettingsKeys.RetractionMinTravel, SettingsKeys.WipeDistance, SettingsKeys.RestoreDuringDescent, SettingsKeys.StartDistance,
        SettingsKeys.StopDistance, SeamKeys.SeamGap, SettingsKeys.SortPaths, SettingsKeys.PrintSequence, SettingsKeys.MergeOverlapping,
        SurfaceKeys.MinLayerTime, SurfaceKeys.MinSpeed, TravelKeys.LayerWait, .. BedKeys.All,
    ];

    /// <summary>Names of such keys that a model sets: their values differ from those of the print, and from the defaults.</summary>
    public static IReadOnlyList<string> SetBy(PrintSettings model, PrintSettings print)
    {
        if (ReferenceEquals(print, model)) return [];
        var usual = new PrintSettings();
        return [.. All.Where(k => !k.IsSame(model, print) && !k.IsSame(model, usual)).Select(k => k.Name)];
    }
}
