using Caterpillar.Basics;
using Caterpillar.Flavors;

namespace Caterpillar.GCode;

/// <summary>What is written of E: the sums of each tool as they should be and as they were printed, whose difference goes into the next number.</summary>
internal sealed class ExtruderSums
{
    // An absolute E beyond this is set back to 0 where a layer begins: firmwares count with 24 bits.
    private const double LargestSum = 1000;
    private const double LargestExact = 1e8;

    private readonly FlavorRules _rules;
    private readonly LineBuffer _out;
    private readonly int _decimals;
    private readonly bool _relative;
    private readonly long _largestSum;
    private readonly Dictionary<int, ExtruderSum> _sums = [];
    private readonly Dictionary<int, double> _rests = [];
    private ExtruderSum _sum = new();

    public ExtruderSums(GCodeFormat format, LineBuffer output)
    {
        (_rules, _out, _decimals) = (format.Flavor, output, format.DecimalsE);
        Letter = format.ExtruderLetter;
        _relative = format.WritesRelative;
        _sums.Add(0, _sum);
        _largestSum = NumberFormatter.ToUnits(LargestSum, _decimals);
    }

    /// <summary>The letter of its words, or 0 where there are none.</summary>
    public byte Letter { get; }

    /// <summary>The number to print for a change of E, and whether the printed sum changes at all.</summary>
    public long Step(double e, out bool changed)
    {
        changed = false;
        if (Letter == 0) return 0;
        var sum = _sum;
        if (Math.Abs(sum.Exact) > LargestExact) Rebase();
        sum.Exact += e;
        var units = NumberFormatter.ToUnits(sum.Exact, _decimals);
        var step = units - sum.Written;
        changed = step != 0;
        sum.Written = units;
        return _relative ? step : units;
    }

    /// <summary>Adds the word of a number to the line.</summary>
    public void Word(long units) => _out.Word(Letter, units, _decimals);

    /// <summary>States whether E is relative, where the firmware has commands for it.</summary>
    public void StateMode()
    {
        if (Letter == 0 || _rules.RelativeE == RelativeERule.OnlyG90G91) return;
        _out.Command((byte)'M', _relative ? 83 : 82);
        _out.EndLine();
    }

    /// <summary>Sets an absolute E back to 0.</summary>
    public void Reset()
    {
        if (Letter == 0 || _relative) return;
        _out.Command((byte)'G', 92);
        _out.Word(Letter, 0, 0);
        _out.EndLine();
        _sum.Forget(_decimals);
    }

    /// <summary>A layer begins, where a large absolute E is set back.</summary>
    public void BeginLayer()
    {
        if (Math.Abs(_sum.Written) > _largestSum) Reset();
    }

    /// <summary>Before the change to another tool: what rounding has left of E belongs to its tool, also where the tools share a position.</summary>
    public void Leave(int tool, int next)
    {
        if (_rules.PositionOfE != PositionOfERule.Shared) return;
        var written = NumberFormatter.FromUnits(_sum.Written, _decimals);
        _rests[tool] = _sum.Exact - written;
        _sum.Exact = _rests.TryGetValue(next, out var rest) ? written + rest : written;
    }

    /// <summary>After the change.</summary>
    public void Enter(int tool)
    {
        if (_rules.PositionOfE == PositionOfERule.Shared) return;
        if (!_sums.TryGetValue(tool, out var sum)) _sums.Add(tool, sum = new ExtruderSum());
        if (_rules.PositionOfE == PositionOfERule.ZeroAtChange) sum.Forget(_decimals);
        _sum = sum;
    }

    // Sums stay within what can be printed.
    private void Rebase()
    {
        if (_relative) _sum.Forget(_decimals);
        else Reset();
    }

    private sealed class ExtruderSum
    {
        public double Exact;
        public long Written;

        // What was not written yet is still to be written.
        public void Forget(int decimals)
        {
            Exact -= NumberFormatter.FromUnits(Written, decimals);
            Written = 0;
        }
    }
}
