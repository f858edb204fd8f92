using System;
using Caterpillar.Basics;
using Caterpillar.Toolpaths;

namespace Caterpillar.GCode;

/// <summary>Coordinate systems: G53, G54 to G59.3, and what G10 sets.</summary>
internal sealed partial class DecoderCore
{
    private const int MostSystems = 9;

    // Zeros of the systems in machine coordinates, three numbers each; null while the file has set none. Replaced, never changed.
    private double[]? _systems;
    private int _system;

    // The words of this line are machine coordinates (G53).
    private bool _machineCoordinates;

    private (double X, double Y, double Z) Origin() => Origin(_system);

    private (double X, double Y, double Z) Origin(int system)
        => _systems is null ? (0, 0, 0) : (_systems[3 * system], _systems[3 * system + 1], _systems[3 * system + 2]);

    // True when the code chooses a system; codes are tenfold.
    private bool Workspace(int code)
    {
        if (code == 530)
        {
            _machineCoordinates = true;
            return true;
        }
        if (code is < 540 or > 593 || (code < 590 && code % 10 != 0)) return false;
        var system = code < 590 ? (code - 540) / 10 : 5 + code - 590;
        if (system == _system) return true;
        var before = Origin();
        _system = system;
        if (system > 0 && Origin() == (0, 0, 0))
            Diagnostics.Add(Severity.Remark, "gcode.workspace",
                "A coordinate system is chosen whose zero the file does not set: it is taken as the zero of the machine.", new SourceLocation(Line: _line));
        Moved(before, Origin());
        return true;
    }

    private void Moved((double X, double Y, double Z) before, (double X, double Y, double Z) after)
    {
        Shift(_shiftX + after.X - before.X, _shiftY + after.Y - before.Y, _shiftZ + after.Z - before.Z);
        _wasPrint = false;
    }

    // G10 and G11 that do not retract.
    private void Offsets(ParsedLine line, int code)
    {
        if (code == 100 && _rules.Workspaces && line.TryGet('L', out var l) && l is 2 or 20)
        {
            SetSystem(line, l == 20);
            return;
        }
        if (code == 100 && _rules.ToolTemperatures && line.TryGet('S', out var celsius) && celsius is > -300 and < 10000 && line.Find('L') < 0)
        {
            AddEvent(new NozzleTemperatureEvent(celsius, false, line.TryGet('P', out var tool) && tool >= 0 && tool < _rules.ToolLimit ? (int)tool : null));
            if (!line.HasAny("XYZ")) return;
        }
        if (line.HasAny("XYZ")) Ignored('G', code / 10.0);
        else Count(code == 100 ? "G10" : "G11");
    }

    private void SetSystem(ParsedLine line, bool here)
    {
        var number = line.Get('P', 0);
        if (!(number is >= 0 and <= MostSystems))
        {
            Count("G10");
            return;
        }
        var system = number < 1 ? _system : (int)number - 1;
        var before = Origin();
        var own = Origin(system);
        var systems = _systems is null ? new double[3 * MostSystems] : (double[])_systems.Clone();
        Set(0, 'X', own.X + (_x + before.X - own.X));
        Set(1, 'Y', own.Y + (_y + before.Y - own.Y));
        Set(2, 'Z', own.Z + (_z + before.Z - own.Z));
        _systems = systems;
        Moved(before, Origin());

        // L2: the word is the zero; L20: the zero is put so that the head stands at the word.
        void Set(int axis, char letter, double stands)
        {
            if (!line.TryGet(letter, out var word)) return;
            word *= Unit;
            if (word is > -Largest and < Largest) systems[3 * system + axis] = here ? stands - word : word;
        }
    }
}
