namespace Caterpillar.Cli;

/// <summary>A moment of a print in words: <c>42%</c>, <c>12m30s</c>, <c>line:1000</c>, <c>move:7</c>, <c>layer:3</c>, <c>z:1.2</c>.</summary>
internal sealed partial class Moment(string text, Func<Timeline, MachineState?> find)
{
    /// <exception cref="CliException">The text is not a moment (wrong usage).</exception>
    public static Moment Parse(string text)
    {
        var plain = text.Trim();
        if (plain.EndsWith('%') && NumberReader.TryParse(plain[..^1], out var part) && part is >= 0 and <= 100)
            return new(plain, t => t.AtFraction(part / 100));
        if (After(plain, "line:") is { } line && Numbers.Whole(line) is >= 1 and var number) return new(plain, t => t.AtSource(number));
        if (After(plain, "move:") is { } move && Numbers.Whole(move) is >= 0 and var index)
            return new(plain, t => index <= t.Toolpath.Count ? t.AtMove(index) : null);
        if (After(plain, "layer:") is { } layer && Numbers.Whole(layer) is >= 0 and var wanted) return new(plain, t => t.AtLayerNumber(wanted));
        if (After(plain, "z:") is { } height && NumberReader.TryParse(height, out var z)) return new(plain, t => t.AtHeight(z));
        if (Seconds(plain) is { } seconds) return new(plain, t => t.At(seconds));
        throw CliException.Usage($"--at needs a moment, not \"{text}\": 42%, a time such as 90s or 1h12m30s, line:N, move:N, layer:N or z:MM.");
    }

    /// <exception cref="CliException">The print has no such moment (bad input).</exception>
    public MachineState Of(Timeline timeline)
        => find(timeline) ?? throw new CliException(ExitCode.BadInput, $"--at {text} is not in the print, which has {Places(timeline)}.");

    private static string Places(Timeline timeline)
    {
        var (moves, layers) = (timeline.Toolpath.Count, timeline.Toolpath.Layers);
        return Figures.Count(moves, "move") + " and " + (layers.Count == 0 ? "no layers"
            : $"layers {NumberFormatter.Format(layers.Min(l => l.Index))} to {NumberFormatter.Format(layers.Max(l => l.Index))}");
    }

    private static string? After(string text, string start) => text.StartsWith(start, StringComparison.OrdinalIgnoreCase) ? text[start.Length..] : null;

    // Hours, minutes and seconds in this order, or seconds alone.
    private static double? Seconds(string text)
    {
        if (NumberReader.TryParse(text, out var plain)) return plain >= 0 ? plain : null;
        var parts = Time().Match(text).Groups;
        double sum = 0;
        foreach (var (unit, seconds) in new[] { ("h", 3600), ("m", 60), ("s", 1) })
        {
            if (!parts[unit].Success) continue;
            if (!NumberReader.TryParse(parts[unit].Value, out var value) || value < 0) return null;
            sum += value * seconds;
        }
        return text.Length > 0 && parts[0].Success ? sum : null;
    }

    [GeneratedRegex(@"^((?<h>\P{L}+)h)?((?<m>\P{L}+)m)?((?<s>\P{L}+)s)?\z", RegexOptions.IgnoreCase | RegexOptions.ExplicitCapture)]
    private static partial Regex Time();
}
