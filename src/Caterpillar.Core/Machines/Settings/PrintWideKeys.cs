namespace Caterpillar.Machines;

/// <summary>Keys of print settings that apply to a whole print: a model cannot have its own value.</summary>
internal static class PrintWideKeys
{
    // Skirt, brim and raft, and accelerations and jerk, as a whole.
    private static readonly string[] Starts = ["skirt_", "brim_", "raft_"];
    private static readonly string[] Ends = ["_acceleration_mm_s2", "_jerk_mm_s"];

    private static readonly IReadOnlyList<ProfileKey<PrintSettings>> All =
    [
        .. ProfileKinds.Settings.KeysOf(
            "travel_speed_mm_s", "z_hop_type", "z_hop_min_travel_mm", "travel_detours", "avoid_crossing_walls", "avoid_crossing_max_detour_mm",
            "retraction_min_travel_mm", "wipe_distance_mm", "deretract_during_descent", "start_distance_mm", "coasting_distance_mm", "seam_gap_mm",
            "sort_paths", "print_sequence", "merge_overlapping_models", "min_layer_time_s", "min_print_speed_mm_s", "layer_time_wait"),
        .. ProfileKinds.Settings.Keys.Where(k => Array.Exists(Starts, s => k.Name.StartsWith(s, StringComparison.Ordinal))),
        .. ProfileKinds.Settings.Keys.Where(k => Array.Exists(Ends, e => k.Name.EndsWith(e, StringComparison.Ordinal))),
        .. ProfileKinds.Settings.KeysOf("purge_tower", "purge_into_infill", "purge_volume_mm3", "purge_tower_width_mm", "purge_tower_place_mm",
            "purge_tower_brim_width_mm"),
    ];

    /// <summary>Names of these keys that a model sets: values that differ from the print and from the defaults.</summary>
    public static IReadOnlyList<string> SetBy(PrintSettings model, PrintSettings print)
    {
        if (ReferenceEquals(print, model)) return [];
        var usual = new PrintSettings();
        return [.. All.Where(k => !k.IsSame(model, print) && !k.IsSame(model, usual)).Select(k => k.Name)];
    }
}
