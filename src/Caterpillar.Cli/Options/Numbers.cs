namespace Caterpillar.Cli;

/// <summary>Reads numbers in option values. Errors are wrong usage.</summary>
internal static class Numbers
{
    public static double[] List(string text, string option) => text.Split(',').Select(part => Number(part, option)).ToArray();

    // mm: no printer is larger, and G-code keeps its decimals.
    private const double Farthest = 1e6;

    /// <summary><c>X,Y</c> or <c>X,Y,Z</c> in mm.</summary>
    public static Vec3 Vector(string text, string option)
    {
        var numbers = List(text, option);
        if (numbers.Length is not (2 or 3)) throw CliException.Usage(option + " needs X,Y or X,Y,Z in mm.");
        if (numbers.Any(n => System.Math.Abs(n) > Farthest)) throw CliException.Usage(option + " needs coordinates up to 1 km.");
        return new Vec3(numbers[0], numbers[1], numbers.Length > 2 ? numbers[2] : 0);
    }

    /// <summary>A factor or percentage for all axes, or one for each.</summary>
    public static Vec3 Scale(string text) => text.Split(',').Select(part => Factor(part, "--scale", 1e-6)).ToArray() switch
    {
        [var all] => new Vec3(all, all, all),
        [var x, var y, var z] => new Vec3(x, y, z),
        _ => throw CliException.Usage("--scale needs a factor, or three of them: X,Y,Z."),
    };

    /// <summary>The length of a unit in mm, from a number or a name; 1 if there is none.</summary>
    public static double Unit(string? text)
    {
        var unit = text?.Trim() switch
        {
            null or "mm" => 1,
            "um" => 0.001,
            "cm" => 10,
            "m" => 1000,
            "in" => 25.4,
            "ft" => 304.8,
            var other => Number(other, "--unit"),
        };
        return unit is > 0 and < 1e6 ? unit : throw CliException.Usage("--unit needs um, mm, cm, m, in, ft or a length above 0 in mm.");
    }

    /// <summary>A factor, or a percentage: <c>0.5</c> and <c>50%</c> are the same.</summary>
    public static double Factor(string text, string option, double least)
    {
        var plain = text.Trim();
        return plain.EndsWith('%') ? Factor(Number(plain[..^1], option) / 100, option, least) : Factor(Number(plain, option), option, least);
    }

    /// <summary>The same for speed and flow, where 70 is meant as 70 %.</summary>
    public static double Ratio(string text, string option, double least)
        => Factor(text, option, least) is <= 10 and var ratio ? ratio
            : throw CliException.Usage(option + " needs a factor up to 10, or a percentage such as 70%.");

    public static double Factor(double value, string option, double least)
        => value >= least && value < 1e6 ? value
            : throw CliException.Usage(option
                + (least > 0 ? " needs a factor above 0 and below a million." : " needs a factor from 0 to a million."));

    /// <summary>A diameter in mm, or null.</summary>
    public static double? Diameter(double? value, string option)
        => value is null or (>= 0.01 and <= 1000) ? value : throw CliException.Usage(option + " needs a diameter of 0.01 to 1000 mm.");

    /// <summary><c>N=TEXT</c>.</summary>
    public static (int Number, string Text) Pair(string text, string option)
    {
        var at = text.IndexOf('=');
        return at > 0 && Whole(text[..at]) is { } number ? (number, text[(at + 1)..])
            : throw CliException.Usage($"{option} needs N=…, not \"{text}\".");
    }

    /// <summary>A number, at least this.</summary>
    public static double AtLeast(string text, string option, double least)
        => NumberReader.TryParse(text.Trim(), out var value) && value >= least ? value
            : throw CliException.Usage($"{option} needs a number{(least >= 0 ? " of 0 or more" : "")}, not \"{text}\".");

    /// <summary>The same, or null.</summary>
    public static double? MaybeAtLeast(string? text, string option, double least) => text is null ? null : AtLeast(text, option, least);

    /// <summary>A number of 0 or more, a percentage of something, or null.</summary>
    public static double? MaybeAmount(string? text, string option, double whole)
        => text?.Trim() is { } plain && plain.EndsWith('%') ? AtLeast(plain[..^1], option, 0) / 100 * whole : MaybeAtLeast(text?.Trim(), option, 0);

    /// <summary>An integer, or null.</summary>
    public static int? Whole(string text) => NumberReader.TryParseInt(text, out var number) ? number : null;

    private static double Number(string text, string option)
        => NumberReader.TryParse(text.Trim(), out var value)
            && double.IsFinite(value) ? value : throw CliException.Usage($"{option} needs a number, not \"{text}\".");
}
