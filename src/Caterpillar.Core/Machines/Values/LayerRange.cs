namespace Caterpillar.Machines;

/// <summary>A height range in mm with its own layer height.</summary>
public readonly record struct LayerRange(double From, double To, double Thickness)
{
    internal static string? Problem(ValueList<LayerRange> ranges)
    {
        for (var i = 0; i < ranges.Count; i++)
        {
            var range = ranges[i];
            if (!(range.From < range.To)) return $"must go upward, not from {NumberFormatter.Shortest(range.From)} to {NumberFormatter.Shortest(range.To)} mm";
            if (!(range.Thickness >= 0.001)) return "must have layer heights of at least 0.001 mm";
            for (var k = 0; k < i; k++)
            {
                if (range.From >= ranges[k].To || ranges[k].From >= range.To) continue;
                return $"has two ranges for {NumberFormatter.Shortest(System.Math.Max(range.From, ranges[k].From))} to "
                    + $"{NumberFormatter.Shortest(System.Math.Min(range.To, ranges[k].To))} mm";
            }
        }
        return null;
    }
}

/// <summary>Speed, fan and flow of walls whose overhang is at least a percentage of their width.</summary>
/// <param name="Percent">0 to 100. At 50 the center line is beyond the layer below.</param>
/// <param name="Speed">mm/s; 0 = unchanged. It never exceeds the normal speed.</param>
/// <param name="MinFanSpeedPercent">Fan speed, %; 0 = unchanged.</param>
/// <param name="Flow">Flow ratio.</param>
public readonly record struct OverhangClass(double Percent, double Speed, double MinFanSpeedPercent, double Flow)
{
    /// <summary>The defaults: slower if the center line overhangs, slower still if the whole width does.</summary>
    public static ValueList<OverhangClass> Usual { get; } = new(new OverhangClass(50, 30, 100, 1), new OverhangClass(100, 20, 100, 1));

    internal static string? Problem(ValueList<OverhangClass> classes)
    {
        for (var i = 0; i < classes.Count; i++)
        {
            if (classes[i].Percent > 100 || classes[i].MinFanSpeedPercent > 100) return "must have percentages up to 100";
            if (!(classes[i].Flow > 0)) return "must have flow ratios above 0";
            if (i > 0 && classes[i].Percent <= classes[i - 1].Percent) return "must have ascending percentages";
        }
        return null;
    }
}
