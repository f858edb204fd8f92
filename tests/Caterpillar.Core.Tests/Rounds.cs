using System;

namespace Caterpillar.Tests;

/// <summary>How many random rounds a test makes: what finds faults by default, more by <c>./test.sh --full</c>, fewer on Mono, which is slow.</summary>
internal static class Rounds
{
    public static bool OnMono { get; } = Type.GetType("Mono.Runtime") is not null;

    public static bool Full { get; } = Environment.GetEnvironmentVariable("CATERPILLAR_FULL") == "1";

    public static int Of(int quick, int full) => Full ? full : quick;

    public static int Of(int quick, int full, int onMono) => OnMono ? onMono : Of(quick, full);
}
