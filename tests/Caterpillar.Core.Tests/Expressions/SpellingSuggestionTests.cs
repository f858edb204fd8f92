using Caterpillar.Expressions;
using NUnit.Framework;

namespace Caterpillar.Tests.Expressions;

internal sealed class SpellingSuggestionTests
{
    [TestCase("forwrd", "forward", "backward", "forward", "toward")]
    [TestCase("lfet", "left", "lift", "left", TestName = "Two swapped letters are one mistake")]
    [TestCase("lleft", "left", "lleft_wing", "left")]
    [TestCase("cat", "bat", "bat", "hat", TestName = "The first of equals")]
    [TestCase("Radius", "radius", "radios", "radius", TestName = "Case is no mistake")]
    [TestCase("fd", "pd", "bk", "pd")]
    [TestCase("fd", null, "bk", "up", TestName = "Two letters may have one mistake")]
    [TestCase("xyzzyx", null, "forward", "radius")]
    [TestCase("abcde", null, "abxyz", TestName = "Five letters may have two mistakes")]
    [TestCase("abcde", "abcyz", "abcyz")]
    [TestCase("abcdef", "abcxyz", "abcxyz")]
    [TestCase("abcdef", null, "abwxyz", TestName = "Longer words may have three")]
    public void The_nearest_word_is_suggested(string word, string? expected, params string[] known)
        => Assert.That(SpellingSuggestion.Nearest(word, known), Is.EqualTo(expected));

    [Test]
    public void The_hint_is_a_question_or_nothing()
    {
        Assert.That(SpellingSuggestion.Hint("forwrd", ["forward"]), Is.EqualTo(" Did you mean 'forward'?"));
        Assert.That(SpellingSuggestion.Hint("xyzzyx", ["forward"]), Is.Empty);
    }

    [TestCase("ol", "lo")]
    public void Letters_swapped_at_the_beginning_are_one_mistake(string word, string meant)
        => Assert.That(SpellingSuggestion.Nearest(word, [meant]), Is.EqualTo(meant));
}
