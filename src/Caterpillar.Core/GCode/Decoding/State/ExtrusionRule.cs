namespace Caterpillar.GCode;

/// <summary>When E counts as printing.</summary>
public enum ExtrusionRule
{
    /// <summary>Only where it exceeds what was retracted, for each tool by itself.</summary>
    Balance,

    /// <summary>Whenever E rises in a motion (the rule of the Caterpillar paper, and of the test data).</summary>
    Rising,
}
