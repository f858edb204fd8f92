namespace Caterpillar.Machines;

/// <summary>Your own check, in addition to <see cref="CheckCodes"/>. It gets every move of a file, in order (see <see cref="PrintSetup"/>).</summary>
public interface IOwnCheck
{
    /// <summary>
    /// Checks the next move and returns a finding, or null. An error prevents writing. The source of the finding is the move. Findings with the same code are
    /// reported once, with a count.
    /// </summary>
    Diagnostic? Look(in Move move);
}
