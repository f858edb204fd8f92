namespace Caterpillar.Machines;

/// <summary>A height in mm from which another tool prints.</summary>
public readonly record struct ToolChange(double From, int Tool)
{
    /// <summary>The highest number of a tool.</summary>
    internal const int Highest = 63;

    internal static ToolChange? Of(double[] n) => new ToolChange(n[0], n[1] == Math.Floor(n[1]) ? (int)n[1] : Highest + 1);

    internal static string? Problem(ValueList<ToolChange> changes)
    {
        for (var i = 0; i < changes.Count; i++)
        {
            if (changes[i].Tool > Highest) return $"must have tool numbers of 0 to {NumberFormatter.Format(Highest)}";
            if (i > 0 && changes[i].From <= changes[i - 1].From) return "must have ascending heights";
        }
        return null;
    }
}
