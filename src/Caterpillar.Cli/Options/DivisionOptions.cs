using Caterpillar.Drawings;

namespace Caterpillar.Cli;

/// <summary>Options for dividing curved parts and for arcs.</summary>
internal sealed class DivisionOptions
{
    private readonly Described<string?> _distance = new("--distance",
        "Divide curved parts by distance; subdivision_distance_mm of the settings by default.", "MM");

    private readonly Described<string?> _tolerance = new("--tolerance", "Divide curved parts so that chords deviate no more than this.", "MM");

    private readonly Described<string?> _angle = new("--angle", "Divide curved parts so that no segment turns more than this.", "DEGREES");

    private readonly Described<string?> _min = new("--min-length", "Shortest segment of a curved part.", "MM");

    private readonly Described<string?> _max = new("--max-length", "Longest segment of a curved part.", "MM");

    private readonly Described<bool> _full = new("--full-steps", "Use the full step and leave a shorter last segment instead of dividing evenly.");

    private readonly Described<bool> _arcs = new("--arcs", "Keep horizontal arcs and circles as G2 and G3.");

    private readonly Described<string?> _fit = new("--fit-arcs", "Fit arcs to printed moves, within this tolerance.", "MM");

    private readonly Described<string?> _merge = new("--merge", "Join curves whose ends touch within this distance.", "MM");

    public Option[] All => [_distance, _tolerance, _angle, _min, _max, _full, _arcs, _fit, _merge];

    public CurveOptions Of(ParseResult arguments, CurveOptions plain)
    {
        double Value(Option<string?> option) => OptionValues.OptionalNumber(arguments.GetValue(option), option.Name, 0) ?? 0;
        var (distance, tolerance, angle) = (Value(_distance), Value(_tolerance), Value(_angle));
        var asked = distance > 0 || tolerance > 0 || angle > 0;
        var division = plain.Subdivision with
        {
            Distance = asked ? distance : plain.Subdivision.Distance,
            ChordTolerance = tolerance,
            Angle = angle,
            MinLength = Value(_min),
            MaxLength = Value(_max),
            EqualDivision = !arguments.GetValue(_full),
            KeepArcs = arguments.GetValue(_arcs),
        };
        if (division.MaxLength > 0 && division.MinLength > division.MaxLength) throw new CliException(ExitCode.Usage, "--min-length is above --max-length.");
        return plain with { Subdivision = division, FitArcs = Value(_fit), MergeTolerance = Value(_merge) };
    }
}
