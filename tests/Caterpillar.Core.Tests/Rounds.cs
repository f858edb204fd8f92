using System;
using System.Collections.Generic;
using System.Linq;

namespace Caterpillar.Tests;

/// <summary>How many random rounds a test makes: what finds faults by default, more by <c>./test.sh --full</c>, fewer on Mono, which is slow.</summary>
internal static class Rounds
{
    public static bool OnMono { get; } = Type.GetType("Mono.Runtime") is not null;

    public static bool Full { get; } = Environment.GetEnvironmentVariable("CATERPILLAR_FULL") == "1";

    public static int Of(int quick, int full) => Full ? full : quick;

    public static int Of(int quick, int full, int onMono) => OnMono ? onMono : Of(quick, full);

    /// <summary>All cases; under Mono, which is slow, every n-th, if not all tests run.</summary>
    public static IEnumerable<T> Some<T>(IEnumerable<T> all, int nth) => Full || !OnMono ? all : all.Where((_, i) => i % nth == 0);

    /// <summary>Of what is tried in each of many cases, by default some for each case, in turn, so that all cases together try all.</summary>
    public static IEnumerable<T> InTurn<T>(IEnumerable<T> all, int nth, int quick)
    {
        if (Full) return all;
        var each = all.ToArray();
        return Enumerable.Range(nth * quick, quick).Select(i => each[i % each.Length]);
    }
}
