namespace Caterpillar.GH.Base;

/// <summary>The steps of a list input for a setup. They stay one object from solve to solve while they stay the same.</summary>
internal sealed class StepList(IReadOnlyList<StepGoo> goos, PrintSetup setup)
{
    private readonly IReadOnlyList<Step> _given = goos.Select(g => g.Value).ToArray();

    public Step[] Steps { get; } = goos.Select(g => g.StepFor(setup)).ToArray();

    public bool Has(IReadOnlyList<StepGoo> goos) => goos.Count == _given.Count && goos.Zip(_given, (goo, step) => Same(goo.Value, step)).All(same => same);

    /// <summary>True if planning sees no difference. Goo may make a new step of the same path.</summary>
    public static bool Same(Step a, Step b) => ReferenceEquals(a, b) || (a is PathStep p && b is PathStep q && ReferenceEquals(p.Path, q.Path)
        && p.Group == q.Group && p.KeepStart == q.KeepStart && p.Joined == q.Joined && ReferenceEquals(p.Region, q.Region) && Equals(p.Source, q.Source));
}
