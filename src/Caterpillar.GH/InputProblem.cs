namespace Caterpillar.GH;

/// <summary>An input of one item that can't be used: the item gives null, the others are solved.</summary>
internal sealed class InputProblem(string message) : Exception(message)
{
    /// <summary>True if the input is missing rather than wrong.</summary>
    public bool IsMissing { get; init; }
}
