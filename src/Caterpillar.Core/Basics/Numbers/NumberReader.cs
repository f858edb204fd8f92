using System.Numerics;

namespace Caterpillar.Basics;

/// <summary>
/// Reads decimal numbers from text: correctly rounded, the same value on every runtime and culture (the parsers of the runtimes disagree
/// in the last bit). The decimal point is <c>.</c>, there are no group separators.
/// </summary>
public static class NumberReader
{
    private static readonly double[] ExactPowers =
        [1, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6, 1e7, 1e8, 1e9, 1e10, 1e11, 1e12, 1e13, 1e14, 1e15, 1e16, 1e17, 1e18, 1e19, 1e20, 1e21, 1e22];

    /// <summary>Reads text that is a single number: sign, digits, point, exponent. False for other text and for numbers beyond the range of double.</summary>
    public static bool TryParse(string? text, out double value)
    {
        value = 0;
        if (string.IsNullOrEmpty(text)) return false;
        var bytes = new byte[text!.Length];
        for (var i = 0; i < bytes.Length; i++)
        {
            if (text[i] > 127) return false;
            bytes[i] = (byte)text[i];
        }
        return TryParse(bytes, 0, bytes.Length, out value);
    }

    /// <inheritdoc cref="TryParse(string?, out double)"/>
    public static bool TryParse(byte[] text, int start, int end, out double value)
        => Scan(text, start, end, true, out value) == end && end > start && !double.IsInfinity(value);

    /// <summary>Reads an integer (sign and digits only) that fits into an int.</summary>
    public static bool TryParseInt(string? text, out int value)
    {
        value = 0;
        if (string.IsNullOrEmpty(text)) return false;
        var negative = text![0] == '-';
        var at = negative || text[0] == '+' ? 1 : 0;
        if (at == text.Length) return false;
        long sum = 0;
        for (; at < text.Length; at++)
        {
            var digit = text[at] - '0';
            if (digit is < 0 or > 9) return false;
            sum = sum * 10 + digit;
            if (sum > int.MaxValue) return false;
        }
        value = (int)(negative ? -sum : sum);
        return true;
    }

    /// <summary>
    /// Reads the number that begins at <paramref name="start"/> and returns the index after it, or <paramref name="start"/> if there is none.
    /// Accepts <c>+5</c>, <c>.5</c> and <c>5.</c>; an exponent only if <paramref name="exponent"/> is set and a digit follows.
    /// A number beyond the range of double gives an infinity.
    /// </summary>
    public static int Scan(byte[] text, int start, int end, bool exponent, out double value)
    {
        value = 0;
        var at = start;
        var negative = false;
        if (at < end && (text[at] == '-' || text[at] == '+')) negative = text[at++] == '-';
        var firstDigit = at;
        ulong mantissa = 0;
        var significant = 0;
        var dropped = 0;
        var decimals = 0;
        var digits = 0;
        for (; at < end && (uint)(text[at] - '0') <= 9; at++, digits++) Push(text[at] - '0', ref mantissa, ref significant, ref dropped);
        if (at < end && text[at] == '.')
        {
            at++;
            for (; at < end && (uint)(text[at] - '0') <= 9; at++, digits++, decimals++) Push(text[at] - '0', ref mantissa, ref significant, ref dropped);
        }
        if (digits == 0) return start;
        var lastDigit = at;
        var power = exponent ? ReadExponent(text, ref at, end) : 0;
        var scale = power - decimals + dropped;
        if (dropped == 0 && mantissa <= 1UL << 53 && scale is >= -22 and <= 22)
            value = scale < 0 ? mantissa / ExactPowers[-scale] : mantissa * ExactPowers[scale];
        else
            value = Exact(text, firstDigit, lastDigit, power - decimals);
        if (negative) value = -value;
        return at;
    }

    private static void Push(int digit, ref ulong mantissa, ref int significant, ref int dropped)
    {
        if (significant >= 18)
        {
            dropped++;
            return;
        }
        mantissa = mantissa * 10 + (uint)digit;
        if (mantissa != 0) significant++;
    }

    private static int ReadExponent(byte[] text, ref int at, int end)
    {
        if (at >= end || (text[at] != 'e' && text[at] != 'E')) return 0;
        var p = at + 1;
        var negative = p < end && text[p] == '-';
        if (p < end && (text[p] == '-' || text[p] == '+')) p++;
        if (p >= end || (uint)(text[p] - '0') > 9) return 0;
        var power = 0;
        for (; p < end && (uint)(text[p] - '0') <= 9; p++) power = Math.Min(power * 10 + (text[p] - '0'), 100_000);
        at = p;
        return negative ? -power : power;
    }

    // digits × 10^scale, rounded half to even, by integer arithmetic.
    private static double Exact(byte[] text, int from, int to, int scale)
    {
        var number = BigInteger.Zero;
        ulong chunk = 0;
        ulong chunkPower = 1;
        var hasMore = false;
        var used = 0;
        for (var i = from; i < to; i++)
        {
            if (text[i] == '.') continue;
            // 800 digits decide every rounding; further ones can only break a tie, which a final 1 does as well.
            if (used >= 800)
            {
                scale++;
                hasMore |= text[i] != '0';
                continue;
            }
            chunk = chunk * 10 + (uint)(text[i] - '0');
            chunkPower *= 10;
            if (chunk != 0 || !number.IsZero) used++;
            if (chunkPower < 1_000_000_000_000_000_000) continue;
            number = number * chunkPower + chunk;
            chunk = 0;
            chunkPower = 1;
        }
        number = number * chunkPower + chunk;
        if (hasMore)
        {
            number = number * 10 + 1;
            scale--;
        }
        if (number.IsZero) return 0;
        var decimalLength = used + scale;
        if (decimalLength > 400) return double.PositiveInfinity;
        if (decimalLength < -400) return 0;
        var denominator = BigInteger.One;
        if (scale >= 0) number *= BigInteger.Pow(10, scale);
        else denominator = BigInteger.Pow(10, -scale);
        return Quotient(number, denominator);
    }

    private static double Quotient(BigInteger number, BigInteger denominator)
    {
        var shift = 66 - (BitLength(number) - BitLength(denominator));
        if (shift > 0) number <<= shift;
        else denominator <<= -shift;
        var quotient = BigInteger.DivRem(number, denominator, out var remainder);
        var length = BitLength(quotient);
        // value = quotient × 2^-shift; its highest bit is at 2^(length - 1 - shift).
        var exponent = length - 1 - shift;
        var bits = exponent >= -1022 ? 53 : 53 - (-1022 - exponent);
        if (bits < 0) return 0;
        var drop = length - bits;
        var kept = quotient >> drop;
        var rest = quotient - (kept << drop);
        var half = BigInteger.One << (drop - 1);
        var order = rest.CompareTo(half);
        if (order > 0 || (order == 0 && (!remainder.IsZero || !kept.IsEven))) kept += 1;
        if (exponent > 1023) return double.PositiveInfinity;
        // The highest bit counts as 1 of the exponent. What is rounded up to a power of 2 carries: into the exponent, infinity or the smallest normal number.
        return BitConverter.Int64BitsToDouble(exponent >= -1022 ? ((long)(exponent + 1022) << 52) + (long)kept : (long)kept);
    }

    private static int BitLength(BigInteger value)
    {
        var bytes = value.ToByteArray();
        var top = bytes.Length - 1;
        while (top > 0 && bytes[top] == 0) top--;
        var length = top * 8;
        for (int last = bytes[top]; last > 0; last >>= 1) length++;
        return length;
    }
}
