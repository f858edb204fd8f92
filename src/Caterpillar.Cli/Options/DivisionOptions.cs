namespace Caterpillar.Cli;

/// <summary>Options for the division of curved parts and for arcs.</summary>
internal sealed class DivisionOptions
{
    private readonly Described<string?> _distance = new("--distance",
        "Segment length of curved parts. Default: subdivision_distance_mm.", "MM");

    private readonly Described<string?> _tolerance = new("--tolerance", "Maximum deviation of segments from curved parts.", "MM");

    private readonly Described<string?> _angle = new("--angle", "Maximum angle that a curved part turns in one segment.", "DEGREES");

    private readonly Described<string?> _min = new("--min-length", "Minimum segment length of curved parts.", "MM");

    private readonly Described<string?> _max = new("--max-length", "Maximum segment length of curved parts.", "MM");

    private readonly Described<bool> _full = new("--full-steps",
        "Keep the exact segment length and make the last segment shorter, instead of dividing evenly.");

    private readonly Described<bool> _arcs = new("--arcs", "Keep horizontal arcs and circles as G2 and G3.");

    private readonly Described<string?> _fit = new("--fit-arcs", "Fit arcs to printing moves within this tolerance.", "MM");

    private readonly Described<string?> _merge = new("--merge", "Join curves whose ends are within this distance.", "MM");

    public Option[] All => [_distance, _tolerance, _angle, _min, _max, _full, _arcs, _fit, _merge];

    public CurveOptions Of(ParseResult arguments, CurveOptions plain)
    {
        double Value(Option<string?> option) => Numbers.MaybeAtLeast(arguments.GetValue(option), option.Name, 0) ?? 0;
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
        if (division.MaxLength > 0 && division.MinLength > division.MaxLength) throw CliException.Usage("--min-length is above --max-length.");
        return plain with { Subdivision = division, FitArcs = Value(_fit), MergeTolerance = Value(_merge) };
    }
}
