namespace Caterpillar.Machines;

/// <summary>A height in mm from which another tool prints.</summary>
public readonly record struct ToolChange(double From, int Tool)
{
    internal static ToolChange? Of(double[] n) => n[1] == Math.Floor(n[1]) ? new ToolChange(n[0], (int)n[1]) : null;

    internal static string? Problem(ValueList<ToolChange> changes)
        => changes.Zip(changes.Skip(1), (a, b) => b.From <= a.From).Contains(true) ? "must have ascending heights" : null;
}
