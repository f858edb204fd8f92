using System.Collections.Generic;
using Caterpillar.Dialects;
using Caterpillar.Geometry;
using Caterpillar.Toolpaths;

namespace Caterpillar.GCode;

/// <summary>Lines from elsewhere, and after them again what they may have changed: modes, unit, tool and position.</summary>
public sealed partial class GCodeWriter
{
    private readonly RawEffects _raw;

    // The head may be elsewhere than the next move begins.
    private bool _positionLost;
    private double _travelSpeed;
    private bool _g91;

    private void Raw(IReadOnlyList<string> lines)
    {
        // Lines from elsewhere may count on absolute positions.
        SetRelative(false);
        foreach (var line in lines) _out.Line(line);
        Restate(lines);
    }

    // G91 or G90; firmware that lets the last of them decide about E is told again.
    private void SetRelative(bool relative)
    {
        if (relative == _g91) return;
        _g91 = relative;
        Modal(relative ? 91 : 90);
        StateModeOfE();
    }

    // The next move states its whole position and its speed.
    private void Restate(IReadOnlyList<string> lines)
    {
        _raw.Read(lines);
        if (_raw.Switch is { } on) _on = on;
        if (_raw.Unit && _rules.Inches) Modal(21);
        if (_raw.Plane && _rules.Planes)
        {
            _plane = ArcPlane.XY;
            Modal(17);
        }
        if (_raw.Modes || _raw.E) StateModes();
        if (_raw.Tool is { } tool && tool != _tool) StateTool(_tool);
        if (!_raw.Position && !_raw.Unit) return;
        _positionLost |= _positionKnown;
        _positionKnown = false;
        _f = long.MinValue;
    }

    // Strands begin where the path does, not where lines from elsewhere have left the head.
    private void ReturnTo(ToolpathColumns c, int block, int i)
    {
        if (!_positionLost) return;
        _positionLost = false;
        if (c.Kind[i] is MoveKind.Travel or MoveKind.Dwell) return;
        var start = i > 0 ? new Vec3(c.X[i - 1], c.Y[i - 1], c.Z[i - 1]) : _toolpath.StartOf(block);
        Straight(start.X, start.Y, start.Z, 0, _travelSpeed > 0 ? _travelSpeed : c.Speed[i], 0);
    }

    private void Modal(int code)
    {
        _out.Command((byte)'G', code);
        _out.EndLine();
    }
}
