namespace Caterpillar.Basics;

/// <summary>Numbers in sentences: short, but neither rounded to 0 nor a page of digits.</summary>
internal static class Figures
{
    private const int Figure = 3;
    private const double Large = 1e9;

    /// <summary>Two decimals, more for numbers below 0.1, and powers of ten from a billion on.</summary>
    public static string Short(double value)
    {
        if (double.IsNaN(value)) return "not a number";
        var size = Math.Abs(value);
        if (double.IsInfinity(value)) return value > 0 ? "infinite" : "minus infinite";
        if (size >= Large) return Power(value);
        if (size is 0 or >= 0.1) return NumberFormatter.Format(value, 2);
        var decimals = (int)Math.Ceiling(-Math.Log10(size)) + Figure - 1;
        return decimals <= NumberFormatter.MaxDecimals ? NumberFormatter.Format(value, decimals) : Power(value);
    }

    /// <summary>A count with its noun: "1 move", "2 moves".</summary>
    public static string Count(long count, string noun) => NumberFormatter.Format(count) + " " + noun + (count == 1 ? "" : "s");

    // Read from the digits: powers of ten are not the same on every runtime.
    private static string Power(double value)
    {
        var text = Math.Abs(value).ToString("E2", System.Globalization.CultureInfo.InvariantCulture);
        var e = text.IndexOf('E', 0);
        var digits = text.Substring(0, e).TrimEnd('0').TrimEnd('.');
        var exponent = int.Parse(text.Substring(e + 1), System.Globalization.CultureInfo.InvariantCulture);
        return (value < 0 ? "-" : "") + digits + "e" + NumberFormatter.Format(exponent);
    }
}
