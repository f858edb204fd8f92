namespace Caterpillar.Machines;

/// <summary>The codes of all checks. The key <c>check_severities</c> of a printer changes their severities.</summary>
public static class CheckCodes
{
    public const string Outside = "bed.outside";
    public const string Below = "bed.below";
    public const string ExcludedArea = "bed.excluded_area";
    public const string NozzleHits = "collision.nozzle";
    public const string TravelHits = "collision.travel";
    public const string HeadHits = "collision.head";
    public const string GantryHits = "collision.gantry";
    public const string ClipHit = "collision.clip";
    public const string Slope = "collision.slope";
    public const string TooLow = "nozzle.too_low";
    public const string Unsupported = "extrusion.unsupported";
    public const string Duplicate = "extrusion.duplicate";
    public const string Squeezed = "extrusion.squeezed";
    public const string Blob = "extrusion.blob";
    public const string Width = "extrusion.width";
    public const string Height = "extrusion.height";
    public const string Starved = "extrusion.starved";
    public const string Gap = "extrusion.gap";
    public const string InAir = "first_layer.in_air";
    public const string FirstLayer = "first_layer.area";
    public const string Flow = "limit.flow";
    public const string Speed = "limit.speed";
    public const string TravelSpeed = "limit.travel_speed";
    public const string Acceleration = "limit.acceleration";
    public const string Raised = "limit.raised";
    public const string Tool = "limit.tool";
    public const string NozzleTemperature = "limit.nozzle_temperature";
    public const string BedTemperature = "limit.bed_temperature";
    public const string ChamberTemperature = "limit.chamber_temperature";
    public const string Stationary = "limit.stationary";
    public const string Amount = "limit.amount";
    public const string ColdExtrusion = "limit.cold_extrusion";
    public const string FilePosition = "file.position";
    public const string FileExtrusion = "file.extrusion";
    public const string FileModes = "file.modes";
    public const string ExtrusionMode = "file.e_mode";
    public const string NoHoming = "file.no_homing";
    public const string NoHeating = "file.no_heating";
    public const string UnknownPosition = "file.unknown_position";
    public const string HeatLeftOn = "file.heat_left_on";
    public const string UnsafeCommand = "command.unsafe";
    public const string UnknownCommand = "command.not_understood";
    public const string UnverifiedCommand = "command.unverified";
    public const string PauseCommand = "command.pause";
    public const string MachineCommand = "command.depends";
    public const string SettingCommand = "command.setting";

    /// <summary>All checks, with their default severities and what they find.</summary>
    public static IReadOnlyList<CheckRule> All { get; } =
    [
        new(Outside, Severity.Error, "moves outside the build volume"),
        new(Below, Severity.Error, "moves below the bed"),
        new(ExcludedArea, Severity.Error, "extrusions in an excluded area of the bed"),
        new(NozzleHits, Severity.Error, "the nozzle hits an earlier extrusion while it prints"),
        new(TravelHits, Severity.Error, "the nozzle hits an earlier extrusion on a travel move"),
        new(HeadHits, Severity.Error, "a box of the print head hits an earlier extrusion"),
        new(GantryHits, Severity.Error, "the gantry hits an earlier extrusion"),
        new(ClipHit, Severity.Error, "the nozzle, print head or gantry hits a bed clip"),
        new(Slope, Severity.Note, "the flat of the nozzle tip cuts into a slope of up to 45° next to it"),
        new(TooLow, Severity.Error, "more than 5 mm of extrusions with a gap to the bed, the object or what is solid of less than 30 % of their height"),
        new(Unsupported, Severity.Warning, "extrusions in the air: more than 5 mm with a free end, or more than 60 mm between two supports"),
        new(Duplicate, Severity.Warning, "more than 20 mm of a path in the same place as another extrusion"),
        new(Squeezed, Severity.Warning, "more material than fits under the nozzle: more than 5 mm of extrusions with less than 60 % of their height, or a blob "
            + "wider than 10 nozzle diameters"),
        new(Blob, Severity.Error, "blobs wider than 20 nozzle diameters"),
        new(Width, Severity.Warning, "more than 5 mm of extrusions wider than 3 nozzle diameters, or narrower than a fifth of one"),
        new(Height, Severity.Warning, "layers higher than the nozzle diameter"),
        new(Starved, Severity.Warning, "retractions in the middle of an extrusion, and extrusions that only make up for a retraction"),
        new(Gap, Severity.Note, "gaps of 0.1 to 1 mm in a straight line of extrusions"),
        new(InAir, Severity.Error, "prints that begin in the air: more than 5 mm of the first extrusion touch neither the bed nor an object"),
        new(FirstLayer, Severity.Warning, "prints higher than 8 times the square root of their contact area with the bed"),
        new(Flow, Severity.Error, "flow above the maximum volumetric flow of hot end or material"),
        new(Speed, Severity.Warning, "extrusions faster than the axes or the extruder allow"),
        new(TravelSpeed, Severity.Note, "travel moves faster than the axes allow, or retractions faster than the extruder allows"),
        new(Acceleration, Severity.Note, "accelerations above the maximum of the axes"),
        new(Raised, Severity.Note, "commands that raise a speed or jerk limit above the limit of the printer"),
        new(Tool, Severity.Error, "tools that the printer does not have"),
        new(NozzleTemperature, Severity.Error, "nozzle temperatures above the maximum of the printer"),
        new(BedTemperature, Severity.Error, "bed temperatures above the maximum of the printer"),
        new(ChamberTemperature, Severity.Warning, "chamber temperatures above the maximum of the printer"),
        new(Stationary, Severity.Error, "too much material extruded or retracted in place"),
        new(Amount, Severity.Error, "moves that extrude far more than a nozzle prints, or retract more than any retraction"),
        new(ColdExtrusion, Severity.Error, "extrusion with a cold nozzle"),
        new(FilePosition, Severity.Error, "lines of the file that move the head to another point than planned"),
        new(FileExtrusion, Severity.Error, "lines of the file that extrude another amount than planned"),
        new(FileModes, Severity.Error, "raw lines that leave the machine in another mode"),
        new(ExtrusionMode, Severity.Error, "E values that make sense only in the other mode, absolute or relative"),
        new(NoHoming, Severity.Warning, "files that print without homing"),
        new(NoHeating, Severity.Warning, "files that extrude without heating the nozzle"),
        new(UnknownPosition, Severity.Warning, "extrusions before the positions of all three axes are known"),
        new(HeatLeftOn, Severity.Warning, "nozzles or beds that are still heated at the end"),
        new(UnsafeCommand, Severity.Error, "commands that lose position, scale or heat, or move unpredictably, in that part of a print"),
        new(UnknownCommand, Severity.Warning, "commands of a file that are not understood"),
        new(UnverifiedCommand, Severity.Error, "commands to be written that are not understood"),
        new(PauseCommand, Severity.Note, "commands that pause the print"),
        new(MachineCommand, Severity.Note, "commands whose effect depends on the machine"),
        new(SettingCommand, Severity.Note, "commands before or after the print that change calibration, coordinates or stored settings"),
    ];

    /// <summary>The check with a code; null if the code is unknown.</summary>
    public static CheckRule? Find(string code) => All.FirstOrDefault(r => r.Code == code);
}

/// <summary>A check.</summary>
/// <param name="Code">Code of its findings.</param>
/// <param name="Severity">Default severity of the findings.</param>
/// <param name="Summary">What the check finds, without a period.</param>
public sealed record CheckRule(string Code, Severity Severity, string Summary);

/// <summary>Severity of the findings of a check on a printer.</summary>
/// <param name="Code">A code of <see cref="CheckCodes"/>.</param>
/// <param name="Severity">Severity of the findings; null = off.</param>
public readonly record struct CheckSeverity(string Code, Severity? Severity)
{
    private static readonly string[] Words = ["note", "warning", "error"];

    /// <summary>Reads <c>code=severity</c>; null and the problem if the text is invalid.</summary>
    internal static CheckSeverity? Parse(string text, out string? problem)
    {
        problem = null;
        var cut = text.IndexOf('=', 0);
        var code = (cut < 0 ? text : text.Substring(0, cut)).Trim();
        var word = cut < 0 ? "" : text.Substring(cut + 1).Trim();
        if (CheckCodes.Find(code) is null)
        {
            problem = $"has \"{code}\", which is not the code of a check";
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
