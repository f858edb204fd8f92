using System.Numerics;

namespace Caterpillar.Basics;

/// <summary>
/// Formats numbers in all output: the same bytes on every runtime and culture. Never an exponent, never <c>-0</c>,
/// no trailing zeros, ties rounded away from zero.
/// </summary>
public static class NumberFormatter
{
    /// <summary>The maximum number of decimals.</summary>
    internal const int MaxDecimals = 15;

    private const double ExactLimit = 9e15;

    private static readonly double[] PowersOfTen =
        [1, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6, 1e7, 1e8, 1e9, 1e10, 1e11, 1e12, 1e13, 1e14, 1e15];

    private static readonly uint[] SmallPowers = [1, 10, 100, 1_000, 10_000, 100_000, 1_000_000, 10_000_000, 100_000_000, 1_000_000_000];

    /// <summary>
    /// The formatted number as a count of units of the last decimal: <c>ToUnits(1.0005, 3)</c> is 1001. Two values that print the same
    /// have equal units, so "no move" is decided with them.
    /// </summary>
    /// <exception cref="ArgumentOutOfRangeException">The value is not finite, or its units exceed 9·10¹⁵, or decimals are not 0 to 15.</exception>
    public static long ToUnits(double value, int decimals)
    {
        var scaled = Scale(value, decimals);
        if (Math.Abs(scaled) > ExactLimit) ThrowTooLarge();
        return Round(scaled);
    }

    /// <summary>The double nearest to <paramref name="units"/> of the last decimal; the inverse of <see cref="ToUnits"/>.</summary>
    internal static double FromUnits(long units, int decimals) => units / PowersOfTen[CheckDecimals(decimals)];

    /// <summary>Formats a number with at most <paramref name="decimals"/> decimals.</summary>
    /// <exception cref="ArgumentOutOfRangeException">The value is not finite, or decimals are not 0 to 15.</exception>
    public static string Format(double value, int decimals)
    {
        var scaled = Scale(value, decimals);
        if (Math.Abs(scaled) > ExactLimit) return FormatLarge(value, decimals);
        var buffer = new byte[24];
        return Encoding.ASCII.GetString(buffer, 0, WriteUnits(buffer, 0, Round(scaled), decimals));
    }

    /// <summary>The shortest decimal text that reads back as the same number, or the number rounded to 15 decimals.</summary>
    public static string Shortest(double value)
    {
        for (var decimals = 0; decimals < MaxDecimals; decimals++)
        {
            var text = Format(value, decimals);
            if (NumberReader.TryParse(text, out var back) && back == value) return text;
        }
        return Format(value, MaxDecimals);
    }

    /// <summary>Formats an integer.</summary>
    public static string Format(long value) => value.ToString(CultureInfo.InvariantCulture);

    /// <summary>
    /// Writes <paramref name="units"/> of the last decimal as ASCII into <paramref name="buffer"/> from <paramref name="at"/> on and returns the index
    /// after it. At most 24 bytes are written; the caller provides the space.
    /// </summary>
    public static int WriteUnits(byte[] buffer, int at, long units, int decimals)
    {
        var magnitude = units < 0 ? (ulong)-units : (ulong)units;
        if (units < 0) buffer[at++] = (byte)'-';
        if (magnitude <= uint.MaxValue && decimals < SmallPowers.Length) return WriteSmall(buffer, at, (uint)magnitude, decimals);
        while (decimals > 0 && magnitude % 10 == 0)
        {
            magnitude /= 10;
            decimals--;
        }
        var length = 1;
        for (var rest = magnitude / 10; rest > 0; rest /= 10) length++;
        if (length <= decimals) length = decimals + 1;
        var end = at + length + (decimals > 0 ? 1 : 0);
        for (var p = end - 1; p >= at; p--)
        {
            if (decimals > 0 && p == end - 1 - decimals)
            {
                buffer[p] = (byte)'.';
                continue;
            }
            buffer[p] = (byte)('0' + (int)(magnitude % 10));
            magnitude /= 10;
        }
        return end;
    }

    // In arithmetic of 32 bits, which is several times as fast.
    private static int WriteSmall(byte[] buffer, int at, uint magnitude, int decimals)
    {
        var power = SmallPowers[decimals];
        var whole = magnitude / power;
        var rest = magnitude - whole * power;
        var end = at + (whole < 10 ? 1 : whole < 100 ? 2 : whole < 1000 ? 3 : Length(whole));
        for (var p = end - 1; p >= at; p--)
        {
            var tenth = whole / 10;
            buffer[p] = (byte)('0' + (whole - tenth * 10));
            whole = tenth;
        }
        if (rest == 0) return end;
        buffer[end] = (byte)'.';
        for (var p = end + decimals; p > end; p--)
        {
            var tenth = rest / 10;
            buffer[p] = (byte)('0' + (rest - tenth * 10));
            rest = tenth;
        }
        end += decimals + 1;
        while (buffer[end - 1] == '0') end--;
        return end;
    }

    private static int Length(uint whole)
    {
        var length = 1;
        while (length < SmallPowers.Length && whole >= SmallPowers[length]) length++;
        return length;
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static double Scale(double value, int decimals)
    {
        // Infinities and NaN give NaN.
        if (double.IsNaN(value - value)) ThrowNotFinite();
        return value * PowersOfTen[CheckDecimals(decimals)];
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static int CheckDecimals(int decimals)
    {
        if ((uint)decimals > MaxDecimals) ThrowDecimals();
        return decimals;
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static long Round(double scaled)
    {
        var magnitude = Math.Abs(scaled);
        var floor = Math.Floor(magnitude);
        var units = (long)(magnitude - floor >= 0.5 ? floor + 1 : floor);
        return scaled < 0 ? -units : units;
    }

    private static void ThrowNotFinite() => throw new ArgumentOutOfRangeException("value", "The number is not finite.");

    private static void ThrowTooLarge() => throw new ArgumentOutOfRangeException("value", "The number is too large for this many decimals.");

    private static void ThrowDecimals() => throw new ArgumentOutOfRangeException("decimals", "Decimals must be 0 to 15.");

    // Too large for 64-bit units: the whole part and the fraction are each exact.
    private static string FormatLarge(double value, int decimals)
    {
        var magnitude = Math.Abs(value);
        var whole = Math.Floor(magnitude);
        var units = new BigInteger(whole) * (long)PowersOfTen[decimals] + Round((magnitude - whole) * PowersOfTen[decimals]);
        var digits = units.ToString(CultureInfo.InvariantCulture);
        var text = decimals == 0
            ? digits
            : (digits.Substring(0, digits.Length - decimals) + "." + digits.Substring(digits.Length - decimals)).TrimEnd('0').TrimEnd('.');
        return value < 0 ? "-" + text : text;
    }
}
