namespace Caterpillar.GH.Base;

/// <summary>The result of an item is not there yet: a component, this one or one upstream, still works on it. A solution follows when it is done.</summary>
internal sealed class StillWorking(string component) : Exception
{
    /// <summary>Nickname of the component that works.</summary>
    public string Component { get; } = component;
}

/// <summary>The item has no result. Its diagnostics explain why.</summary>
internal sealed class NoResult : Exception;
