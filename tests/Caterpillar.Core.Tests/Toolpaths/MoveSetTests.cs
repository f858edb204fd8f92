using System;
using System.Collections.Generic;
using System.Linq;
using Caterpillar.Toolpaths;
using NUnit.Framework;

namespace Caterpillar.Tests.Toolpaths;

internal static class MoveSets
{
    public static MoveSet ToMoveSet(this IEnumerable<bool> values)
    {
        bool[] all = [.. values];
        var set = new MoveSet(all.Length);
        for (var i = 0; i < all.Length; i++) set[i] = all[i];
        return set;
    }

    public static bool[] ToArray(this MoveSet set, int count) => [.. Enumerable.Range(0, count).Select(i => set[i])];
}

/// <summary>A set of moves answers as an array of flags does.</summary>
public class MoveSetTests
{
    [Test]
    public void Moves_are_found_as_in_an_array_of_flags()
    {
        var random = new Random(8);
        for (var round = 0; round < 200; round++)
        {
            var (count, share) = (random.Next(300), random.Next(5));
            bool[] flags = [.. Enumerable.Range(0, count).Select(_ => random.Next(4) < share)];
            var set = flags.ToMoveSet();
            Assert.That(set.ToArray(count), Is.EqualTo(flags));
            var from = random.Next(count + 1);
            var end = random.Next(from, count + 1);
            foreach (var value in new[] { true, false })
            {
                var found = Array.IndexOf(flags, value, from, end - from);
                Assert.That(set.Find(value, from, end), Is.EqualTo(found < 0 ? end : found));
            }
        }
    }

    [Test]
    public void A_move_can_leave_the_set()
    {
        var set = Enumerable.Repeat(true, 130).ToMoveSet();
        set[64] = false;
        Assert.That(set.Find(false, 0, 130), Is.EqualTo(64));
        Assert.That(set.Find(false, 65, 130), Is.EqualTo(130));
    }
}
