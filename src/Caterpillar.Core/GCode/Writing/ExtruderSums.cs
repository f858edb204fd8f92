namespace Caterpillar.GCode;

/// <summary>Written E: the exact and the written sum of each tool. Their difference goes into the next number.</summary>
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
        (_rules, _out, _decimals) = (format.Flavor, output, format.Printer.DecimalsE);
        Letter = format.ExtruderLetter;
        _relative = format.WritesRelative;
        _sums.Add(0, _sum);
        _largestSum = NumberFormatter.ToUnits(LargestSum, _decimals);
    }

    /// <summary>The letter of E words. 0 = none.</summary>
    public byte Letter { get; }

    /// <summary>The number to print for a change of E, and whether the printed sum changes at all.</summary>
    public long Step(double e, out bool changed)
    {
        changed = false;
        if (Letter == 0) return 0;
        var sum = _sum;
        // Sums stay within what can be printed.
        if (Math.Abs(sum.Exact) > LargestExact)
        {
            if (_relative) sum.Forget(_decimals);
            else Reset();
        }
        sum.Exact += e;
        var units = NumberFormatter.ToUnits(sum.Exact, _decimals);
        var step = units - sum.Written;
        changed = step != 0;
        sum.Written = units;
        return _relative ? step : units;
    }

    /// <summary>Adds the word of a number to the line.</summary>
    public void Word(long units) => _out.Word(Letter, units, _decimals);

    /// <summary>Writes the mode of E if the firmware has commands for it.</summary>
    public void StateMode()
    {
        if (Letter == 0 || _rules.RelativeE == RelativeERule.OnlyG90G91) return;
        _out.Command((byte)'M', _relative ? 83 : 82);
        _out.EndLine();
    }

    /// <summary>Resets absolute E to 0.</summary>
    public void Reset()
    {
        if (Letter == 0 || _relative) return;
        _out.Command((byte)'G', 92);
        _out.Word(Letter, 0, 0);
        _out.EndLine();
        _sum.Forget(_decimals);
    }

    /// <summary>Begins a layer. A large absolute E is reset.</summary>
    public void BeginLayer()
    {
        if (Math.Abs(_sum.Written) > _largestSum) Reset();
    }

    /// <summary>Called before a tool change. Each tool keeps its rounding error of E, even if the tools share a position.</summary>
    public void Leave(int tool, int next)
    {
        if (_rules.PositionOfE != PositionOfERule.Shared) return;
        var written = NumberFormatter.FromUnits(_sum.Written, _decimals);
        _rests[tool] = _sum.Exact - written;
        _sum.Exact = _rests.TryGetValue(next, out var rest) ? written + rest : written;
    }

    /// <summary>Called after a tool change.</summary>
    public void Enter(int tool)
    {
        if (_rules.PositionOfE == PositionOfERule.Shared) return;
        if (!_sums.TryGetValue(tool, out var sum)) _sums.Add(tool, sum = new ExtruderSum());
        if (_rules.PositionOfE == PositionOfERule.ZeroAtChange) sum.Forget(_decimals);
        _sum = sum;
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
