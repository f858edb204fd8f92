using System;

namespace Caterpillar.Basics;

/// <summary>Progress of long work: a number from 0 to 1.</summary>
public static class ProgressExtensions
{
    /// <summary>The stretch from <paramref name="from"/> to <paramref name="to"/> of a larger progress, as a progress from 0 to 1 of its own.</summary>
    public static IProgress<double>? Part(this IProgress<double>? progress, double from, double to)
        => progress is null ? null : new Stretch(progress, from, to);

    private sealed class Stretch(IProgress<double> whole, double from, double to) : IProgress<double>
    {
        public void Report(double value) => whole.Report(from + (to - from) * value);
    }
}
