using Caterpillar.GH.Base;
using NUnit.Framework;

namespace Caterpillar.GH.Tests.Base;

public sealed class SolveCacheTests
{
    [Test]
    public void A_value_is_kept_for_one_solve_after_its_last_use()
    {
        var cache = new SolveCache();
        object Solve(int key)
        {
            cache.Begin();
            var value = cache.Get<object>([key, "text", new object?[] { 1.5, null }], _ => new object());
            cache.End();
            return value;
        }
        var first = Solve(1);
        Assert.That(Solve(1), Is.SameAs(first));
        Solve(2);
        Assert.That(Solve(1), Is.Not.SameAs(first));
    }

    [Test]
    public void While_something_is_worked_on_the_last_complete_solve_is_kept()
    {
        var cache = new SolveCache();
        object Solve(int key, bool complete)
        {
            cache.Begin();
            var value = cache.Get<object>([key], _ => new object());
            cache.End(complete);
            return value;
        }
        var first = Solve(1, true);
        Solve(2, false);
        Solve(3, false);
        Assert.That(Solve(1, true), Is.SameAs(first));
        Solve(2, true);
        Assert.That(Solve(1, true), Is.Not.SameAs(first));
    }

    [Test]
    public void What_is_cleared_is_made_again_also_within_a_solve()
    {
        var cache = new SolveCache();
        cache.Begin();
        var first = cache.Get<object>([1], _ => new object());
        cache.Clear();
        Assert.That(cache.Get<object>([1], _ => new object()), Is.Not.SameAs(first));
    }

    [Test]
    public void Results_of_two_types_under_one_key_are_told_apart()
    {
        var cache = new SolveCache();
        cache.Begin();
        cache.Get<string>([1], _ => "text");
        Assert.That(cache.Get<int[]>([1], _ => [2]), Is.EqualTo(new[] { 2 }));
    }

    [Test]
    public void A_key_is_found_without_a_walk_through_all()
    {
        var cache = new SolveCache();
        var asked = 0;
        for (var solve = 0; solve < 2; solve++)
        {
            cache.Begin();
            for (var i = 0; i < 1000; i++) cache.Get<object>([new Counted(i, () => asked++)], _ => new object());
            cache.End();
        }
        Assert.That(asked, Is.InRange(1000, 2000), "Comparing each with all others would be half a million.");
    }

    private sealed class Counted(int value, System.Action asked)
    {
        private readonly int _value = value;

        public override bool Equals(object? obj)
        {
            asked();
            return obj is Counted other && other._value == _value;
        }

        public override int GetHashCode() => _value;
    }
}
