using FlagKey = Caterpillar.Machines.ProfileKey<Caterpillar.Machines.PrintSettings, bool>;
using NumberKey = Caterpillar.Machines.ProfileKey<Caterpillar.Machines.PrintSettings, double>;

namespace Caterpillar.Machines;

// Where a tool leaves the rest of another material.
public sealed partial record PrintSettings
{
    /// <summary>Purge tools after a change on a tower beside the models.</summary>
    public bool PurgeTower { get; init; }

    /// <summary>Purge tools after a change into infill, as far as there is some. Infill may then have the tool of another part.</summary>
    public bool PurgeIntoInfill { get; init; }

    /// <summary>Volume purged at each tool change; 0 = 140 for a shared nozzle, otherwise 15.</summary> <value>mm³.</value>
    public double PurgeVolume { get; init => field = PurgeKeys.PurgeVolume.Check(value); }

    /// <summary>Width of the purge tower in X. Its depth depends on the volume.</summary> <value>mm.</value>
    public double PurgeTowerWidth { get; init => field = PurgeKeys.PurgeTowerWidth.Check(value); } = 35;

    /// <summary>Width of the brim of the purge tower; 0 = off.</summary> <value>mm.</value>
    public double PurgeTowerBrimWidth { get; init => field = PurgeKeys.PurgeTowerBrimWidth.Check(value); } = 3;

    /// <summary>Front left corner of the purge tower, without its brim; empty = next to the models.</summary>
    /// <value>mm.</value> <remarks>One point, or none.</remarks>
    public ValueList<Vec3> PurgeTowerPosition { get; init => field = PurgeKeys.PurgeTowerPosition.Check(value); } = ValueList<Vec3>.Empty;

    /// <summary>Volume to purge at each tool change, mm³.</summary>
    /// <param name="printer">The printer; null = unknown.</param>
    internal double PurgeVolumeFor(Printer? printer) => PurgeVolume > 0 ? PurgeVolume : printer is { SharedNozzle: false } ? 15 : 140;
}

/// <summary>Keys of print settings: purging after tool changes.</summary>
internal static class PurgeKeys
{
    public static readonly KeyTable<PrintSettings> All = new();

    public static readonly FlagKey PurgeTower = All.Boolean("purge_tower", s => s.PurgeTower, (s, v) => s with { PurgeTower = v });
    public static readonly FlagKey PurgeIntoInfill
        = All.Boolean("purge_into_infill", s => s.PurgeIntoInfill, (s, v) => s with { PurgeIntoInfill = v });
    public static readonly NumberKey PurgeVolume = All.Number("purge_volume_mm3", 0, 100_000, s => s.PurgeVolume, (s, v) => s with { PurgeVolume = v });
    public static readonly NumberKey PurgeTowerWidth
        = All.Number("purge_tower_width_mm", 10, 10_000, s => s.PurgeTowerWidth, (s, v) => s with { PurgeTowerWidth = v });
    public static readonly NumberKey PurgeTowerBrimWidth
        = All.Number("purge_tower_brim_width_mm", 0, 1000, s => s.PurgeTowerBrimWidth, (s, v) => s with { PurgeTowerBrimWidth = v });
    public static readonly ProfileKey<PrintSettings, ValueList<Vec3>> PurgeTowerPosition = All.Of(
        "purge_tower_position_mm", new RowsFormat<Vec3>(["x", "y"], 1, -100_000, 100_000, n => new Vec3(n[0], n[1]), v => [v.X, v.Y]),
        s => s.PurgeTowerPosition, (s, v) => s with { PurgeTowerPosition = v });
}
