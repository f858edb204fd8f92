namespace Caterpillar.Cli;

/// <summary>Reads numbers and percentages in option values.</summary>
internal static class OptionValues
{
    /// <exception cref="CliException">The text is not a number, or the number is too small (wrong usage).</exception>
    public static double Number(string text, string option, double least)
    {
        if (NumberReader.TryParse(text.Trim(), out var value) && value >= least) return value;
        throw new CliException(ExitCode.Usage, $"{option} needs a number{(least >= 0 ? " of 0 or more" : "")}, not \"{text}\".");
    }

    public static double? OptionalNumber(string? text, string option, double least) => text is null ? null : Number(text, option, least);

    /// <summary>A number, or a percentage of something.</summary>
    public static double? OptionalAmount(string? text, string option, double whole)
    {
        if (text is null) return null;
        var plain = text.Trim();
        return plain.EndsWith('%') ? Number(plain[..^1], option, 0) / 100 * whole : Number(plain, option, 0);
    }
}

/// <summary>Reads the values of <c>--map</c>.</summary>
internal static class AxisMappings
{
    public static AxisMapping Parse(string text)
    {
        var equals = text.IndexOf('=');
        var star = text.IndexOf('*');
        if (equals == 1 && star == 3 && Axis(text[0]) is { } from && Word(text[2]) is { } to && NumberReader.TryParse(text[4..], out var scale) && scale != 0)
        {
            if (to < OutputAxis.X || to - OutputAxis.X == (int)from) return new AxisMapping(from, to, scale);
        }
        throw new CliException(ExitCode.Usage, $"--map {text}: expected AXIS=WORD*SCALE, such as X=A*2.86 (degrees per mm) or Y=Y*0.5.");
    }

    private static PathAxis? Axis(char c) => c switch { 'X' or 'x' => PathAxis.X, 'Y' or 'y' => PathAxis.Y, 'Z' or 'z' => PathAxis.Z, _ => null };

    private static OutputAxis? Word(char c) => Enum.TryParse<OutputAxis>(c.ToString(), true, out var word) && char.IsLetter(c) ? word : null;
}
