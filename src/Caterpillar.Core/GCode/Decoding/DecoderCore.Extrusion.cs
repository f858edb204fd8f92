using System;
using Caterpillar.Dialects;
using Caterpillar.Machines;

namespace Caterpillar.GCode;

/// <summary>Words of E: mode, unit, and the change that a word asks for.</summary>
internal sealed partial class DecoderCore
{
    private const double Inch = 25.4;

    // Positions of two extruder axes, where A and B stand in one file.
    private double _a;
    private double _b;

    private double UnitOfE => !_inches ? 1 : _rules.InchesOfE switch
    {
        InchesOfERule.Unchanged => 1,
        InchesOfERule.InchesOrCubic when _volumetric => Inch * Inch * Inch,
        _ => Inch,
    };

    private void SetM83(bool on)
    {
        if (on) Features.M83++;
        else Features.M82++;
        if (_rules.RelativeE == RelativeERule.OnlyG90G91)
        {
            Ignored('M', on ? 83 : 82);
            return;
        }
        _m83 = on;
        _lastRelative = on;
        Modes();
    }

    private double ChangeOfE(double word)
    {
        word *= UnitOfE;
        if (!(word is < LargestE and > -LargestE))
        {
            OutOfRange();
            return 0;
        }
        if (_modesDiffer)
            Differs("gcode.dialect_e_mode", "E is absolute or relative depending on the firmware here (order of G90, G91, M82, M83); " + _rules.Title
                + " takes it as " + (_relativeE ? "relative." : "absolute."));
        var change = _relativeE ? word : word - _e;
        _e += change;
        if (_shadow)
        {
            var other = _lastRelative ? word : word - _shadowE;
            _shadowE += other;
            if (Math.Abs(other) >= NoChange) DecodeCounters.EMarlin2 += other;
        }
        return change;
    }

    private bool ExtruderWord(ParsedLine line, out double value)
    {
        value = 0;
        if (!_axis.HasAmounts) return false;
        if (_axis != ExtrusionAxis.Both) return line.TryGet((char)_axis.Letter, out value);
        var hasA = line.TryGet('A', out var a) && a is > -LargestE and < LargestE;
        var hasB = line.TryGet('B', out var b) && b is > -LargestE and < LargestE;
        value = TwoAxes(a, hasA, b, hasB);
        return hasA || hasB;
    }

    // Two extruder axes become one E: the sum of what both change.
    private double TwoAxes(double a, bool hasA, double b, bool hasB)
    {
        double change = 0;
        if (hasA)
        {
            change += _relativeE ? a : a - _a;
            _a = _relativeE ? _a + a : a;
        }
        if (hasB)
        {
            change += _relativeE ? b : b - _b;
            _b = _relativeE ? _b + b : b;
        }
        return _relativeE ? change : _e / UnitOfE + change;
    }
}
