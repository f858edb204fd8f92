namespace Caterpillar.GCode;

/// <summary>E words: changes of E, and G92 E.</summary>
internal sealed class ExtruderWords(Machine machine)
{
    private const double LargestE = MoveRecorder.LargestE;
    private readonly FlavorRules _rules = machine.Rules;
    private readonly ExtrusionAxis _axis = machine.Axis;
    private readonly InterpreterState _state = machine.State;

    /// <summary>The change of E in a line. 0 = no E word.</summary>
    public double Change(ParsedLine line) => TryGet(line, out var word) ? Change(word) : 0;

    public double Change(double word)
    {
        word *= _state.Modes.UnitOfE(_rules);
        if (!(word is < LargestE and > -LargestE))
        {
            machine.Moves.OutOfRange();
            return 0;
        }
        ref var modes = ref _state.Modes;
        ref var extrusion = ref _state.Extrusion;
        if (modes.IsRelativeEDisputed)
            machine.Diagnostics.Warn("gcode.flavor_e_mode", "Whether E is absolute or relative here depends on the firmware (order of G90, G91, M82, M83). "
                + _rules.Title + " reads it as " + (modes.RelativeE ? "relative." : "absolute."));
        var change = modes.RelativeE ? word : word - extrusion.E;
        extrusion.E += change;
        if (extrusion.HasMarlin2E)
        {
            var other = modes.LastRelative ? word : word - extrusion.Marlin2E;
            extrusion.Marlin2E += other;
            if (Math.Abs(other) >= InterpreterState.NoChange) machine.Counters.EMarlin2 += other;
        }
        return change;
    }

    public bool TryGet(ParsedLine line, out double value)
    {
        value = 0;
        if (!_axis.HasAmounts) return false;
        if (_axis != ExtrusionAxis.Both) return line.TryGet((char)_axis.Letter, out value);
        var hasA = line.TryGet('A', out var a) && a is > -LargestE and < LargestE;
        var hasB = line.TryGet('B', out var b) && b is > -LargestE and < LargestE;
        value = SumOfBoth(a, hasA, b, hasB);
        return hasA || hasB;
    }

    /// <summary>G92 E: renames the position. False if the line has no E word.</summary>
    public bool Rename(ParsedLine line)
    {
        if (!_axis.HasAmounts) return false;
        ref var extrusion = ref _state.Extrusion;
        if (_axis == ExtrusionAxis.Both)
        {
            var any = line.TryGet('A', out var a);
            if (any) extrusion.A = a;
            if (line.TryGet('B', out var b)) extrusion.B = b;
            else if (!any) return false;
            return true;
        }
        if (!line.TryGet((char)_axis.Letter, out var e)) return false;
        e *= _state.Modes.UnitOfE(_rules);
        if (!(e is > -LargestE and < LargestE)) return false;
        extrusion.SetE(e);
        return true;
    }

    // Two extruder axes become one E: the sum of what both change.
    private double SumOfBoth(double a, bool hasA, double b, bool hasB)
    {
        var relative = _state.Modes.RelativeE;
        ref var extrusion = ref _state.Extrusion;
        double change = 0;
        if (hasA)
        {
            change += relative ? a : a - extrusion.A;
            extrusion.A = relative ? extrusion.A + a : a;
        }
        if (hasB)
        {
            change += relative ? b : b - extrusion.B;
            extrusion.B = relative ? extrusion.B + b : b;
        }
        return relative ? change : extrusion.E / _state.Modes.UnitOfE(_rules) + change;
    }
}
