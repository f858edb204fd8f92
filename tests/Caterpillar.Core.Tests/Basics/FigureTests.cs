using Caterpillar.Basics;
using NUnit.Framework;

namespace Caterpillar.Tests.Basics;

public class FigureTests
{
    [TestCase(0, "0")]
    [TestCase(12.345, "12.35")]
    [TestCase(-3, "-3")]
    [TestCase(0.1, "0.1")]
    [TestCase(0.01234, "0.0123")]
    [TestCase(0.0001, "0.0001")]
    [TestCase(-0.000456789, "-0.000457")]
    [TestCase(1e-20, "1e-20")]
    [TestCase(999999999.0, "999999999")]
    [TestCase(1e9, "1e9")]
    [TestCase(-1.234e300, "-1.23e300")]
    [TestCase(double.PositiveInfinity, "infinite")]
    [TestCase(double.NegativeInfinity, "minus infinite")]
    [TestCase(double.NaN, "not a number")]
    public void A_number_in_a_sentence_is_short_and_never_rounded_to_nothing(double value, string text) => Assert.That(Figures.Short(value), Is.EqualTo(text));

    [TestCase("to (1234567890123456789012345, 0)", "to (1.2e24, 0)")]
    [TestCase("1000000000000000000000000000000", "1e30")]
    [TestCase("0.1234567890123456789012345678", "0.1234567890123456789012345678")]
    [TestCase("1234567890 and 123456789012345678901234", "1234567890 and 123456789012345678901234")]
    public void Long_digits_in_messages_are_powers_of_ten(string text, string shorter) => Assert.That(LongWords.Shorten(text), Is.EqualTo(shorter));

    [TestCase(120, false)]
    [TestCase(121, true)]
    public void A_word_of_more_than_120_characters_loses_its_middle_wherever_it_is(int length, bool isLong)
    {
        var word = new string('a', length - 1) + "b";
        var shorter = isLong ? new string('a', 40) + "…" + new string('a', 19) + "b" : word;
        Assert.That(LongWords.Shorten("see " + word), Is.EqualTo("see " + shorter));
        Assert.That(LongWords.Shorten(word + " there"), Is.EqualTo(shorter + " there"));
    }
}
