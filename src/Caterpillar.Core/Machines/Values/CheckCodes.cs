using Caterpillar.Basics;

namespace Caterpillar.Machines;

/// <summary>What is checked, by the codes of its findings. A printer's <c>check_severities</c> change how serious each is.</summary>
public static class CheckCodes
{
    public const string Outside = "bed.outside";
    public const string Below = "bed.below";
    public const string PrintArea = "bed.print_area";
    public const string NozzleHits = "collision.nozzle";
    public const string TravelHits = "collision.travel";
    public const string HeadHits = "collision.head";
    public const string GantryHits = "collision.gantry";
    public const string ClipHit = "collision.clip";
    public const string DigsIn = "nozzle.digs_in";
    public const string TooLow = "nozzle.too_low";
    public const string Unsupported = "extrusion.unsupported";
    public const string Doubled = "extrusion.duplicate";
    public const string Squeezed = "extrusion.squeezed";
    public const string Blob = "extrusion.blob";
    public const string Width = "extrusion.width";
    public const string Height = "extrusion.height";
    public const string Gap = "extrusion.gap";
    public const string FirstLayer = "first_layer.area";
    public const string Flow = "limit.flow";
    public const string Speed = "limit.speed";
    public const string TravelSpeed = "limit.travel_speed";
    public const string Acceleration = "limit.acceleration";
    public const string Raised = "limit.raised";
    public const string Tool = "limit.tool";
    public const string NozzleTemperature = "limit.nozzle_temperature";
    public const string BedTemperature = "limit.bed_temperature";
    public const string Stationary = "limit.stationary";
    public const string ColdExtrusion = "limit.cold_extrusion";
    public const string FilePosition = "file.position";
    public const string FileExtrusion = "file.extrusion";
    public const string FileModes = "file.modes";
    public const string ExtrusionMode = "file.e_mode";
    public const string NoHoming = "file.no_homing";
    public const string NoHeating = "file.no_heating";
    public const string UnknownPosition = "file.unknown_position";
    public const string HeatLeftOn = "file.heat_left_on";

    /// <summary>All of them, with their usual severity and what they find.</summary>
    public static IReadOnlyList<CheckRule> All { get; } =
    [
        new(Outside, Severity.Error, "a move outside the space that the nozzle can reach"),
        new(Below, Severity.Error, "a move below the bed"),
        new(PrintArea, Severity.Error, "an extrusion on an excluded area of the bed"),
        new(NozzleHits, Severity.Error, "the nozzle goes through what is printed, while it prints"),
        new(TravelHits, Severity.Error, "the nozzle goes through what is printed, on a travel"),
        new(HeadHits, Severity.Error, "a box of the head goes through what is printed"),
        new(GantryHits, Severity.Error, "the gantry goes through what is printed"),
        new(ClipHit, Severity.Error, "nozzle, head or gantry hit a clip on the bed"),
        new(DigsIn, Severity.Note, "the flat of the nozzle digs into a slope of up to 45° beside it"),
        new(TooLow, Severity.Error, "more than 5 mm of extrusions with a gap below the nozzle of less than 30 % of their height"),
        new(Unsupported, Severity.Warning, "extrusions in the air: more than 5 mm at a free end, or more than 60 mm between two supports"),
        new(Doubled, Severity.Warning, "more than 20 mm of a path in the place of another extrusion"),
        new(Squeezed, Severity.Warning, "more material than fits between the nozzle and what is below it: an extrusion would be more than four nozzles wide, "
            + "a blob in place more than ten"),
        new(Blob, Severity.Error, "material in place that spreads wider than twenty nozzles"),
        new(Width, Severity.Warning, "more than 5 mm of extrusions wider than three nozzles, or thinner than a fifth of one"),
        new(Height, Severity.Warning, "layers higher than the nozzle is wide"),
        new(Gap, Severity.Note, "a straight line of extrusions with a gap of 0.1 to 1 mm"),
        new(FirstLayer, Severity.Warning, "a print that is higher than eight times the root of the area on which it stands"),
        new(Flow, Severity.Error, "more material than hot end and material allow"),
        new(Speed, Severity.Warning, "extrusions faster than the axes or the extruder"),
        new(TravelSpeed, Severity.Note, "travels faster than the axes, retractions faster than the extruder"),
        new(Acceleration, Severity.Note, "accelerations above those of the axes"),
        new(Raised, Severity.Note, "a command that raises a limit of speed or jerk above that of the printer"),
        new(Tool, Severity.Error, "a tool that the printer does not have"),
        new(NozzleTemperature, Severity.Error, "a nozzle hotter than the printer allows"),
        new(BedTemperature, Severity.Error, "a bed hotter than the printer allows"),
        new(Stationary, Severity.Error, "too much material pushed out, or pulled back, while the head stands still"),
        new(ColdExtrusion, Severity.Error, "extrusion with a cold nozzle"),
        new(FilePosition, Severity.Error, "a line of the file that moves the head elsewhere than was planned"),
        new(FileExtrusion, Severity.Error, "a line of the file that extrudes another amount than was planned"),
        new(FileModes, Severity.Error, "a raw line that leaves the machine in another mode"),
        new(ExtrusionMode, Severity.Error, "amounts of E that make sense only in the other mode, absolute or relative"),
        new(NoHoming, Severity.Warning, "a file that prints and does not home"),
        new(NoHeating, Severity.Warning, "a file that extrudes and does not heat the nozzle"),
        new(UnknownPosition, Severity.Warning, "extrusions before all three axes have a position"),
        new(HeatLeftOn, Severity.Warning, "a nozzle or a bed that is still heated at the end"),
    ];

    /// <summary>The rule of a code, or null.</summary>
    public static CheckRule? Find(string code) => All.FirstOrDefault(r => r.Code == code);
}

/// <summary>A check.</summary>
/// <param name="Code">Code of its findings.</param>
/// <param name="Severity">How serious they are, unless the printer says otherwise.</param>
/// <param name="Summary">What it finds, after "finds".</param>
public sealed record CheckRule(string Code, Severity Severity, string Summary);

/// <summary>How serious the findings of a check are on a printer.</summary>
/// <param name="Code">A code of <see cref="CheckCodes"/>.</param>
/// <param name="Severity">Null: it is not checked.</param>
public readonly record struct CheckSeverity(string Code, Severity? Severity)
{
    private static readonly string[] Words = ["note", "warning", "error"];

    /// <summary>Reads <c>code=severity</c>; null, and the problem, where it is wrong.</summary>
    internal static CheckSeverity? Parse(string text, out string? problem)
    {
        problem = null;
        var cut = text.IndexOf('=', 0);
        var code = (cut < 0 ? text : text.Substring(0, cut)).Trim();
        var word = cut < 0 ? "" : text.Substring(cut + 1).Trim();
        if (CheckCodes.Find(code) is null)
        {
            problem = $"has \"{code}\", which is not a code of a check";
            return null;
        }
        if (word == "off") return new CheckSeverity(code, null);
        var at = Array.IndexOf(Words, word);
        if (at >= 0) return new CheckSeverity(code, (Severity)at);
        problem = $"needs off, note, warning or error for \"{code}\", not \"{word}\"";
        return null;
    }

    public override string ToString() => Code + "=" + (Severity is { } severity ? Words[(int)severity] : "off");
}
