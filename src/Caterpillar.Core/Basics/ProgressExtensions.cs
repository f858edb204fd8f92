namespace Caterpillar.Basics;

/// <summary>Progress of long work: a number from 0 to 1.</summary>
internal static class ProgressExtensions
{
    /// <summary>The section from <paramref name="from"/> to <paramref name="to"/> of a progress, as a progress from 0 to 1.</summary>
    public static IProgress<double>? Part(this IProgress<double>? progress, double from, double to)
        => progress is null ? null : new Section(progress, from, to);

    private sealed class Section(IProgress<double> whole, double from, double to) : IProgress<double>
    {
        public void Report(double value) => whole.Report(from + (to - from) * value);
    }
}
