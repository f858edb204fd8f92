namespace Caterpillar.Machines;

/// <summary>Keys of print settings that apply to a whole print: a model cannot have its own value.</summary>
internal static class PrintWideKeys
{
    private static readonly IReadOnlyList<ProfileKey<PrintSettings>> All =
    [
        SettingsKeys.TravelSpeed, SettingsKeys.ZHopType, SettingsKeys.ZHopMinTravel, SettingsKeys.Detour, SettingsKeys.Comb, TravelKeys.AvoidCrossingMaxDetour,
        SettingsKeys.RetractionMinTravel, SettingsKeys.WipeDistance, SettingsKeys.DeretractDuringDescent, SettingsKeys.StartDistance,
        SettingsKeys.CoastingDistance, SeamKeys.SeamGap, SettingsKeys.SortPaths, SettingsKeys.PrintSequence, SettingsKeys.MergeOverlappingModels,
        SurfaceKeys.MinLayerTime, SurfaceKeys.MinPrintSpeed, TravelKeys.LayerTimeWait, .. BedKeys.All, .. RoleMotionKeys.All,
        ToolKeys.PurgeTower, ToolKeys.PurgeIntoInfill, ToolKeys.PurgeVolume, ToolKeys.PurgeTowerWidth, ToolKeys.PurgeTowerBrimWidth,
    ];

    /// <summary>Names of these keys that a model sets: values that differ from the print and from the defaults.</summary>
    public static IReadOnlyList<string> SetBy(PrintSettings model, PrintSettings print)
    {
        if (ReferenceEquals(print, model)) return [];
        var usual = new PrintSettings();
        return [.. All.Where(k => !k.IsSame(model, print) && !k.IsSame(model, usual)).Select(k => k.Name)];
    }
}
