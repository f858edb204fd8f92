using Caterpillar.Dialects;
using Caterpillar.Machines;

namespace Caterpillar.GCode;

/// <summary>Factors of speed and material, and E as a volume.</summary>
internal sealed partial class DecoderCore
{
    private double _keptFactor = 1;

    private void SpeedFactor(ParsedLine line)
    {
        var factor = Factor(line, _feedFactor);
        if (_rules.SpeedMemory != SpeedMemoryRule.None)
        {
            var kept = _keptFactor;
            var restores = line.Has('R');
            if (_rules.SpeedMemory == SpeedMemoryRule.RestoresFirst)
            {
                if (line.Has('B')) _keptFactor = _feedFactor;
                if (restores && line.Find('S') < 0) factor = kept;
            }
            else
            {
                if (line.Has('B')) _keptFactor = _feedFactor;
                if (restores) factor = _keptFactor;
            }
        }
        _feedFactor = factor;
        _speed = _feed / 60 * _feedFactor;
    }

    private void FlowFactor(ParsedLine line)
    {
        var tool = _tool;
        if (_rules.FlowToolLetter.Length > 0 && line.TryGet(_rules.FlowToolLetter[0], out var named) && named is >= 0 and < 1000) tool = (int)named;
        if (tool == _tool) _flow = Factor(line, _flow);
        else if (_rules.FlowFactor == FlowFactorRule.PerTool) StateOf(tool).Flow = Factor(line, StateOf(tool).Flow);
    }

    private double Factor(ParsedLine line, double before)
    {
        if (line.TryGet('S', out var percent)) return percent is > 0 and < 1e6 ? percent / 100 : before;
        return _rules.FactorsReset ? 1 : before;
    }

    private void Volumetric(ParsedLine line)
    {
        Features.M200++;
        if (line.TryGet('D', out var diameter)) _volumetric = diameter > 0;
        if (line.TryGet('S', out var on)) _volumetric = on > 0 && _volumetric | diameter == 0;
    }
}
