using System;
using System.CommandLine;
using Caterpillar.Drawings;
using Caterpillar.Geometry;

namespace Caterpillar.Cli.Commands;

/// <summary>Options for dividing curved parts and for arcs.</summary>
internal sealed class DivisionOptions
{
    private readonly Option<string?> _distance =
        new("--distance") { Description = "Divide curved parts by distance; subdivision_distance_mm of the settings by default.", HelpName = "MM" };

    private readonly Option<string?> _tolerance = new("--tolerance") { Description = "Divide curved parts so that chords deviate no more than this.",
        HelpName = "MM" };

    private readonly Option<string?> _angle = new("--angle") { Description = "Divide curved parts so that no segment turns more than this.",
        HelpName = "DEGREES" };

    private readonly Option<string?> _min = new("--min-length") { Description = "Shortest segment of a curved part.", HelpName = "MM" };

    private readonly Option<string?> _max = new("--max-length") { Description = "Longest segment of a curved part.", HelpName = "MM" };

    private readonly Option<bool> _full =
        new("--full-steps") { Description = "Use the full step and leave a shorter last segment instead of dividing evenly." };

    private readonly Option<bool> _arcs = new("--arcs") { Description = "Keep horizontal arcs and circles as G2 and G3." };

    private readonly Option<string?> _fit = new("--fit-arcs") { Description = "Fit arcs to printed moves, within this tolerance.", HelpName = "MM" };

    private readonly Option<string?> _merge = new("--merge") { Description = "Join curves whose ends touch within this distance.", HelpName = "MM" };

    public void AddTo(Verb verb)
    {
        foreach (Option option in new Option[] { _distance, _tolerance, _angle, _min, _max, _full, _arcs, _fit, _merge }) verb.Options.Add(option);
    }

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
