using Caterpillar.Basics;
using Caterpillar.Toolpaths;

namespace Caterpillar.Machines;

/// <summary>A check of your own, beside those of <see cref="CheckCodes"/>: it sees every move of a file, in order (see <see cref="PrintSetup"/>).</summary>
public interface IOwnCheck
{
    /// <summary>
    /// Looks at the next move and returns what is wrong with it, or null. An error refuses to write. The place is that of the move; findings with one code are
    /// told once, with their number.
    /// </summary>
    Diagnostic? Look(in Move move);
}
