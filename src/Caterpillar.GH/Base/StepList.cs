namespace Caterpillar.GH.Base;

/// <summary>The steps of a list input for a setup. They stay one object from solve to solve while they stay the same.</summary>
internal sealed class StepList(IReadOnlyList<StepGoo> goos, PrintSetup setup)
{
    private readonly IReadOnlyList<Step> _given = goos.Select(g => g.Value).ToArray();

    public Step[] Steps { get; } = goos.Select(g => g.StepFor(setup)).ToArray();

    /// <summary>True if planning sees no difference. Goo may make a new step of the same path.</summary>
    public bool Has(IReadOnlyList<StepGoo> goos) => goos.Select(g => g.Value).SequenceEqual(_given);
}
