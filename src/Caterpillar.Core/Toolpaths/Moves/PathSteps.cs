namespace Caterpillar.Toolpaths;

/// <summary>Converts paths to steps.</summary>
public static class PathSteps
{
    /// <summary>The paths as steps in the same order.</summary>
    /// <exception cref="ArgumentNullException">A path is null.</exception>
    public static IReadOnlyList<Step> ToSteps(this IEnumerable<PrintPath> paths)
        => (paths ?? throw new ArgumentNullException(nameof(paths))).Select(path => (Step)path).ToArray();
}
