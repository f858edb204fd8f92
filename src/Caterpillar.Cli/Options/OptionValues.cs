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
