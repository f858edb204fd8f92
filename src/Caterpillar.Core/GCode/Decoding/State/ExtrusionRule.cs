namespace Caterpillar.GCode;

/// <summary>When a rising E prints.</summary>
public enum ExtrusionRule
{
    /// <summary>Only beyond the retraction, for each tool separately.</summary>
    Balance,

    /// <summary>In every motion with rising E (the rule of the Caterpillar paper and of the test data).</summary>
    Rising,
}
