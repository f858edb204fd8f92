namespace Caterpillar.Toolpaths;

/// <summary>Paths as a design.</summary>
public static class PathSteps
{
    /// <summary>The paths as steps in their order, which are not sorted.</summary>
    /// <exception cref="ArgumentNullException">A path is null.</exception>
    public static IReadOnlyList<Step> ToSteps(this IEnumerable<PrintPath> paths)
        => (paths ?? throw new ArgumentNullException(nameof(paths))).Select(path => (Step)path).ToArray();
}
