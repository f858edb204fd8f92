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
    public const string AxisRange = "limit.axis";
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
    public static IReadOnlyList<CheckRule> All { get; } = [.. EmbeddedText.Rows("names/CheckCodes.tsv").Skip(1)
        .Select(row => new CheckRule(row[0], (Severity)Enum.Parse(typeof(Severity), row[1], true), row[2]))];

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
    private const char Wrong = '!';

    private static readonly string[] Words = ["note", "warning", "error"];

    /// <summary>The pattern of the texts in JSON schemas.</summary>
    internal static string Pattern
        => "^(" + string.Join("|", CheckCodes.All.Select(c => string.Join("\\.", c.Code.Split('.')))) + ")=(off|note|warning|error)$";

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

    /// <summary>What is wrong is kept for the message of <see cref="Problem"/>.</summary>
    internal static CheckSeverity OrWrong(string text) => Parse(text, out _) ?? new CheckSeverity(Wrong + text, null);

    /// <summary>What is wrong with severities, or null.</summary>
    internal static string? Problem(ValueList<CheckSeverity> severities)
    {
        if (severities.FirstOrDefault(s => CheckCodes.Find(s.Code) is null) is not { Code: { } code }) return null;
        Parse(code.TrimStart(Wrong), out var problem);
        return problem ?? $"has \"{code}\", which is not the code of a check";
    }

    public override string ToString() => Code + "=" + (Severity is { } severity ? Words[(int)severity] : "off");
}
