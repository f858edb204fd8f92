using Caterpillar.Basics;

namespace Caterpillar.Machines;

/// <summary>The checks, by the codes of their findings. The key <c>check_severities</c> of a printer changes their severities.</summary>
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

    /// <summary>All checks, with their default severities and descriptions.</summary>
    public static IReadOnlyList<CheckRule> All { get; } =
    [
        new(Outside, Severity.Error, "a move outside the build volume"),
        new(Below, Severity.Error, "a move below the bed"),
        new(PrintArea, Severity.Error, "an extrusion on an excluded area of the bed"),
        new(NozzleHits, Severity.Error, "the nozzle collides with the print during extrusion"),
        new(TravelHits, Severity.Error, "the nozzle collides with the print during a travel move"),
        new(HeadHits, Severity.Error, "a box of the print head collides with the print"),
        new(GantryHits, Severity.Error, "the gantry collides with the print"),
        new(ClipHit, Severity.Error, "nozzle, head or gantry collides with a clip on the bed"),
        new(DigsIn, Severity.Note, "the flat of the nozzle digs into a neighboring slope of up to 45°"),
        new(Unsupported, Severity.Warning, "unsupported extrusions: more than 5 mm at a free end, or more than 60 mm between two supports"),
        new(Doubled, Severity.Warning, "more than 20 mm of a path that repeats another extrusion"),
        new(Squeezed, Severity.Warning, "more material than fits under the nozzle: an extrusion of more than four nozzle diameters, "
            + "or a blob of more than ten"),
        new(Width, Severity.Warning, "more than 5 mm of extrusions wider than three nozzle diameters, or narrower than a fifth of one"),
        new(Height, Severity.Warning, "layers higher than the nozzle diameter"),
        new(Gap, Severity.Note, "a gap of 0.1 to 1 mm in a straight line of extrusions"),
        new(FirstLayer, Severity.Warning, "a print higher than eight times the square root of its first layer area"),
        new(Flow, Severity.Error, "more volumetric flow than hot end and material allow"),
        new(Speed, Severity.Warning, "extrusions faster than the axes or the extruder allow"),
        new(TravelSpeed, Severity.Note, "travel moves faster than the axes allow, or retractions faster than the extruder allows"),
        new(Acceleration, Severity.Note, "accelerations above the limits of the axes"),
        new(Raised, Severity.Note, "a command that raises a limit of speed or jerk above the printer's limit"),
        new(Tool, Severity.Error, "a tool that the printer does not have"),
        new(NozzleTemperature, Severity.Error, "a nozzle temperature above the printer's maximum"),
        new(BedTemperature, Severity.Error, "a bed temperature above the printer's maximum"),
        new(Stationary, Severity.Error, "too much material extruded or retracted while the head does not move"),
        new(ColdExtrusion, Severity.Error, "extrusion with a cold nozzle"),
        new(FilePosition, Severity.Error, "a line that moves the head to another position than planned"),
        new(FileExtrusion, Severity.Error, "a line that extrudes another amount than planned"),
        new(FileModes, Severity.Error, "a line of raw G-code that leaves the machine in another mode"),
        new(ExtrusionMode, Severity.Error, "values of E that make sense only in the other mode, absolute or relative"),
        new(NoHoming, Severity.Warning, "a file that prints without homing"),
        new(NoHeating, Severity.Warning, "a file that extrudes without heating the nozzle"),
        new(UnknownPosition, Severity.Warning, "extrusions before all three axes have a known position"),
        new(HeatLeftOn, Severity.Warning, "a nozzle or bed that is still heated at the end"),
    ];

    /// <summary>The check with a code; null if the code is unknown.</summary>
    public static CheckRule? Find(string code) => All.FirstOrDefault(r => r.Code == code);
}

/// <summary>A check.</summary>
/// <param name="Code">Code of its findings.</param>
/// <param name="Severity">Default severity of its findings.</param>
/// <param name="Summary">Description of its findings, as the end of "finds …".</param>
public sealed record CheckRule(string Code, Severity Severity, string Summary);

/// <summary>Severity of a check on a printer.</summary>
/// <param name="Code">A code of <see cref="CheckCodes"/>.</param>
/// <param name="Severity">Null = off.</param>
public readonly record struct CheckSeverity(string Code, Severity? Severity)
{
    private static readonly string[] Words = ["note", "warning", "error"];

    /// <summary>Reads <c>code=severity</c>; null and the problem if it is wrong.</summary>
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
