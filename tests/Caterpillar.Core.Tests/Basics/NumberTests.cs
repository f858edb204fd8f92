using System;
using System.Globalization;
using System.Numerics;
using System.Text;
using Caterpillar.Basics;
using NUnit.Framework;

namespace Caterpillar.Tests.Basics;

public class NumberTests
{
    [TestCase(1.0005, 3, "1.001")]
    [TestCase(-1.2345, 3, "-1.235")]
    [TestCase(-1e-7, 3, "0")]
    [TestCase(0.0, 5, "0")]
    [TestCase(-0.0, 5, "0")]
    [TestCase(1234567.8915, 3, "1234567.892")]
    [TestCase(1e9, 3, "1000000000")]
    [TestCase(1e9 + 0.125, 3, "1000000000.125")]
    [TestCase(0.5, 0, "1")]
    [TestCase(-0.5, 0, "-1")]
    [TestCase(2.5, 0, "3")]
    [TestCase(0.05, 5, "0.05")]
    [TestCase(0.123456785, 8, "0.12345679")]
    [TestCase(-1234.5, 8, "-1234.5")]
    [TestCase(100, 0, "100")]
    [TestCase(1e20, 3, "100000000000000000000")]
    [TestCase(123e18, 5, "123000000000000000000")]
    [TestCase(4503599627370495.5, 5, "4503599627370495.5")]
    [TestCase(-2251799813685247.75, 5, "-2251799813685247.75")]
    public void Numbers_are_written_without_exponent_minus_zero_or_trailing_zeros(double value, int decimals, string expected)
    {
        Assert.That(NumberFormatter.Format(value, decimals), Is.EqualTo(expected));
        if (Math.Abs(value) > 1e12) return;
        var buffer = new byte[40];
        var end = NumberFormatter.WriteUnits(buffer, 3, NumberFormatter.ToUnits(value, decimals), decimals);
        Assert.That(Encoding.ASCII.GetString(buffer, 3, end - 3), Is.EqualTo(expected));
    }

    [Test]
    public void Units_of_any_size_and_decimals_are_written_as_numbers_are_formatted()
    {
        var random = new Random(5);
        var buffer = new byte[40];
        for (var i = 0; i < 200_000; i++)
        {
            var decimals = random.Next(16);
            var units = (long)(Math.Pow(10, random.NextDouble() * 15) * (random.Next(2) * 2 - 1));
            if (random.Next(3) == 0) units -= units % (long)Math.Pow(10, random.Next(12));
            if (random.Next(50) == 0) units = (random.Next(2) * 2 - 1) * (uint.MaxValue + (long)random.Next(-2, 3));
            var end = NumberFormatter.WriteUnits(buffer, 2, units, decimals);
            var text = Math.Abs(units).ToString(CultureInfo.InvariantCulture).PadLeft(decimals + 1, '0');
            if (decimals > 0) text = text.Insert(text.Length - decimals, ".").TrimEnd('0').TrimEnd('.');
            if (Encoding.ASCII.GetString(buffer, 2, end - 2) != (units < 0 ? "-" : "") + text) Assert.Fail($"{units} with {decimals} decimals");
        }
    }

    [TestCase("de-DE")]
    [TestCase("tr-TR")]
    [TestCase("ar-SA")]
    public void The_culture_changes_nothing(string culture)
    {
        var before = CultureInfo.CurrentCulture;
        try
        {
            CultureInfo.CurrentCulture = new CultureInfo(culture);
            Assert.That(NumberFormatter.Format(-1234.5, 3), Is.EqualTo("-1234.5"));
            Assert.That(NumberFormatter.Format(-17), Is.EqualTo("-17"));
            Assert.That(NumberReader.TryParse("-1234.5", out var value), Is.True);
            Assert.That(value, Is.EqualTo(-1234.5));
        }
        finally
        {
            CultureInfo.CurrentCulture = before;
        }
    }

    [Test]
    public void Numbers_that_are_not_finite_are_refused()
    {
        Assert.That(() => NumberFormatter.Format(double.NaN, 3), Throws.InstanceOf<ArgumentOutOfRangeException>());
        Assert.That(() => NumberFormatter.ToUnits(double.PositiveInfinity, 3), Throws.InstanceOf<ArgumentOutOfRangeException>());
        Assert.That(() => NumberFormatter.ToUnits(1e18, 3), Throws.InstanceOf<ArgumentOutOfRangeException>());
    }

    [TestCase("+5", 5)]
    [TestCase("-.5", -0.5)]
    [TestCase("5.", 5)]
    [TestCase("007", 7)]
    [TestCase("1e-3", 1e-3)]
    [TestCase("2.5E+02", 250)]
    [TestCase("0.1", 0.1)]
    [TestCase("9007199254740993", 9007199254740992)]
    [TestCase("9007199254740993.00000000000000000000000000000000001", 9007199254740994)]
    [TestCase("1.7976931348623157e308", double.MaxValue)]
    [TestCase("4.9e-324", double.Epsilon)]
    [TestCase("2.2250738585072011e-308", 2.2250738585072011e-308)]
    [TestCase("2.2250738585072014e-308", 2.2250738585072014e-308)]
    [TestCase("1e-400", 0)]
    [TestCase("0.000000000000000000000000000000000000012345678901234567890123456789", 1.2345678901234567890123456789e-38)]
    [TestCase("123456789012345678901234567890", 123456789012345678901234567890.0)]
    public void Numbers_are_read_correctly_rounded(string text, double expected)
    {
        Assert.That(NumberReader.TryParse(text, out var value), Is.True);
        Assert.That(value, Is.EqualTo(expected));
    }

    [Test]
    public void Numbers_of_hundreds_of_digits_are_read_correctly_rounded()
    {
        double Read(string text)
        {
            Assert.That(NumberReader.TryParse(text, out var value), Is.True, text);
            return value;
        }
        var zeros = new string('0', 900);
        Assert.That(Read("1" + zeros + "e-900"), Is.EqualTo(1));
        Assert.That(Read("0." + zeros + "25e901"), Is.EqualTo(2.5));
        Assert.That(Read("1" + zeros + "1e-890"), Is.EqualTo(1e11));
        Assert.That(Read(new string('3', 450) + "e-450"), Is.EqualTo(1.0 / 3));
        Assert.That(Read("." + new string('9', 900)), Is.EqualTo(1));
        // Half of the last place above 2^53: even without more, up with a digit far to the right.
        Assert.That(Read("9007199254740993." + zeros), Is.EqualTo(9007199254740992));
        Assert.That(Read("9007199254740993." + zeros + "1"), Is.EqualTo(9007199254740994));
        Assert.That(Read("9007199254740995." + zeros), Is.EqualTo(9007199254740996));
    }

    [Test]
    public void What_rounds_beyond_the_largest_number_is_rejected()
    {
        // Halfway between the largest number, which is odd, and the next power of 2.
        var half = BigInteger.Pow(2, 1024) - BigInteger.Pow(2, 970);
        Assert.That(NumberReader.TryParse(half.ToString(CultureInfo.InvariantCulture), out _), Is.False);
        Assert.That(NumberReader.TryParse((half - 1).ToString(CultureInfo.InvariantCulture), out var value), Is.True);
        Assert.That(value, Is.EqualTo(double.MaxValue));
    }

    [TestCase("1.99999999999999999", 2)]
    [TestCase("0.99999999999999999999", 1)]
    [TestCase("8.9999999999999999999e15", 9e15)]
    [TestCase("2.22507385850720138309e-308", 2.2250738585072014e-308)]
    [TestCase("2.4703282292062327e-324", 0)]
    [TestCase("2.4703282292062328e-324", double.Epsilon)]
    public void A_number_that_rounds_up_to_a_power_of_two_is_that_power(string text, double expected)
    {
        Assert.That(NumberReader.TryParse(text, out var value), Is.True);
        Assert.That(value, Is.EqualTo(expected));
    }

    [TestCase("")]
    [TestCase("-")]
    [TestCase(".")]
    [TestCase("1,5")]
    [TestCase("1e")]
    [TestCase("0x10")]
    [TestCase("1e999")]
    [TestCase("NaN")]
    [TestCase("−1")]
    [TestCase("1 ")]
    public void Text_that_is_not_a_number_is_rejected(string text) => Assert.That(NumberReader.TryParse(text, out _), Is.False);

#if NET
    [Test]
    public void Reading_agrees_with_the_runtime_on_random_numbers()
    {
        // .NET's parser is correctly rounded; Mono's is not, so this comparison runs on .NET only.
        var random = new Random(7);
        var bytes = new byte[8];
        for (var i = 0; i < 20_000; i++)
        {
            random.NextBytes(bytes);
            var value = BitConverter.ToDouble(bytes, 0);
            if (double.IsNaN(value) || double.IsInfinity(value)) continue;
            var text = i % 2 == 0 ? value.ToString("R", CultureInfo.InvariantCulture) : (value % 1e6).ToString("F" + i % 20, CultureInfo.InvariantCulture);
            Assert.That(NumberReader.TryParse(text, out var read), Is.True, text);
            Assert.That(read, Is.EqualTo(double.Parse(text, CultureInfo.InvariantCulture)), text);
        }
    }
#endif

    [Test]
    public void A_number_ends_where_its_text_ends()
    {
        var text = Encoding.ASCII.GetBytes("X-12.5Y3E5");
        Assert.That(NumberReader.Scan(text, 1, text.Length, false, out var x), Is.EqualTo(6));
        Assert.That(x, Is.EqualTo(-12.5));
        Assert.That(NumberReader.Scan(text, 7, text.Length, false, out var y), Is.EqualTo(8));
        Assert.That(y, Is.EqualTo(3));
        Assert.That(NumberReader.Scan(text, 7, text.Length, true, out y), Is.EqualTo(10));
        Assert.That(y, Is.EqualTo(300000));
        Assert.That(NumberReader.Scan(text, 6, text.Length, true, out _), Is.EqualTo(6));
    }

    [TestCase("-7", true, -7)]
    [TestCase("+7", true, 7)]
    [TestCase("2147483647", true, int.MaxValue)]
    [TestCase("2147483648", false, 0)]
    [TestCase("-", false, 0)]
    [TestCase("", false, 0)]
    [TestCase("4.", false, 0)]
    [TestCase("1x", false, 0)]
    public void An_integer_is_a_sign_and_digits_only(string text, bool isInteger, int value)
    {
        Assert.That(NumberReader.TryParseInt(text, out var read), Is.EqualTo(isInteger));
        Assert.That(read, Is.EqualTo(value));
    }

    [TestCase("2e308")]
    [TestCase("-2e308")]
    public void Just_beyond_the_range_of_double_is_no_number(string text) => Assert.That(NumberReader.TryParse(text, out _), Is.False);

    [TestCase(1)]
    [TestCase(17)]
    [TestCase(18)]
    [TestCase(19)]
    [TestCase(799)]
    [TestCase(801)]
    [TestCase(2500)]
    public void Zeros_before_the_digits_are_made_good_by_the_exponent(int zeros)
    {
        // 0.00…0625 with so many zeros, times 10 to the number of zeros, is 0.0625; 19 digits more take the exact path.
        Assert.That(NumberReader.TryParse("0." + new string('0', zeros) + "625e" + (zeros - 1), out var few), Is.True);
        Assert.That(few, Is.EqualTo(0.0625));
        Assert.That(NumberReader.TryParse("0." + new string('0', zeros) + "625000000000000000000000e" + zeros, out var many), Is.True);
        Assert.That(many, Is.EqualTo(0.625));
        Assert.That(NumberReader.TryParse(new string('0', zeros) + "625000000000000000000000e-24", out var before), Is.True);
        Assert.That(before, Is.EqualTo(0.625));
    }

    [Test]
    public void Nothing_is_left_of_numbers_below_the_smallest_double()
    {
        foreach (var text in new[] { "1e-324", "2e-324", "1e-400", "1e-401", "1e-999", "0.0000001e-395" })
            Assert.That(NumberReader.TryParse(text, out var value) && value == 0, Is.True, text);
        // Half of the smallest is rounded to even, that is to zero; what is above it is the smallest.
        Assert.That(NumberReader.TryParse("2.4703282292062328e-324", out var above) && above == double.Epsilon, Is.True);
    }
}
