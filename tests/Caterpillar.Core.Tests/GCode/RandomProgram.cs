using System;
using System.Globalization;
using System.Linq;
using System.Text;
using Caterpillar.Basics;
using Caterpillar.Flavors;
using Caterpillar.GCode;
using Caterpillar.Machines;

namespace Caterpillar.Tests.GCode;

/// <summary>Small G-code programs in random styles: modes, units, notation, tools, retraction, arcs, names of places, events.</summary>
internal sealed class RandomProgram
{
    private readonly Random _random;
    private readonly FlavorRules _flavor;
    private readonly StringBuilder _text = new();
    private readonly bool _lower;
    private readonly bool _noSpace;
    private readonly bool _numbered;
    private readonly string _lineEnd;
    private readonly int _tools;
    private readonly bool _firmware;
    private readonly char _e;
    private readonly double[] _ofTool = new double[4];
    private int _number;
    private double _x, _y, _z = 0.3, _sum;
    private double _nameX;
    private bool _g91, _m83, _last, _inches;
    private int _tool, _motion = 1;

    private RandomProgram(Random random, FlavorRules flavor)
    {
        _random = random;
        _flavor = flavor;
        _lower = Chance(0.15);
        _noSpace = Chance(0.15);
        _numbered = Chance(0.2);
        _lineEnd = Chance(0.2) ? "\r\n" : Chance(0.05) ? "\r" : "\n";
        _tools = Chance(0.3) ? 3 : 1;
        _firmware = flavor.FirmwareRetraction && Chance(0.4);
        _e = flavor.ExtruderLetters[0];
    }

    public static string Text(Random random, FlavorRules flavor, int layers = 3)
    {
        var program = new RandomProgram(random, flavor);
        program.Write(layers);
        return program._text.ToString();
    }

    private bool RelativeE => _flavor.RelativeE switch
    {
        RelativeERule.EitherG91OrM83 => _g91 || _m83,
        RelativeERule.LastWins => _last,
        RelativeERule.OnlyM82M83 => _m83,
        _ => _g91,
    };

    private double Unit => _inches ? 25.4 : 1;

    private double UnitOfE => _flavor.InchesOfE == InchesOfERule.Unchanged ? 1 : Unit;

    private bool Chance(double share) => _random.NextDouble() < share;

    private double Around(double low, double high) => Math.Floor((low + (high - low) * _random.NextDouble()) * 1000 + 0.5) / 1000;

    private void Write(int layers)
    {
        if (Chance(0.3)) Comment("made by hand");
        Line("G21");
        Mode(90);
        EMode(Chance(0.5));
        if (Chance(0.5)) Line("G28");
        if (!RelativeE) Line("G92", (_e, 0));
        Motion(0, Around(0, 50), Around(0, 50), 0.3, 0, 6000);
        for (var layer = 0; layer < layers; layer++)
        {
            Comment("LAYER:" + layer.ToString(CultureInfo.InvariantCulture));
            if (layer > 0) Motion(0, Around(0, 50), Around(0, 50), 0.3 + 0.2 * layer, 0, 6000);
            for (var extrusion = _random.Next(1, 4); extrusion > 0; extrusion--) Extrusion();
        }
        if (Chance(0.3)) Line("G28 X");
        Line("M84");
    }

    private void Extrusion()
    {
        Between();
        if (Chance(0.5)) Comment("TYPE:" + new[] { "WALL-OUTER", "FILL", "SKIN", "SUPPORT" }[_random.Next(4)]);
        for (var i = _random.Next(1, 5); i > 0; i--)
        {
            if (_flavor.Arcs && (!_g91 || _flavor.ArcsInRelativeMode) && Chance(0.2)) Arc();
            else Print();
        }
        if (Chance(0.6)) return;
        var length = Around(0.5, 2);
        var firmware = _firmware && Chance(0.7);
        if (firmware) Line("G10");
        else if (Chance(0.2)) Motion(1, _x + Around(-2, 2), _y + 1, _z, -length, 1500);
        else Motion(1, _x, _y, _z, -length, 2400);
        if (Chance(0.3)) Motion(0, _x, _y, _z + 0.4, 0, 6000);
        Motion(Chance(0.5) ? 0 : 1, Around(0, 50), Around(0, 50), _z, 0, Chance(0.5) ? 6000 : 0);
        if (Chance(0.2)) Between();
        if (firmware) Line("G11");
        else if (Chance(0.2))
        {
            Motion(1, _x, _y, _z, length / 2, 1200);
            Motion(1, _x, _y, _z, length / 2, 0);
        }
        else Motion(1, _x, _y, _z, length, 2400);
    }

    // What happens between extrusions.
    private void Between()
    {
        if (Chance(0.12)) Mode(_g91 ? 90 : 91);
        if (Chance(0.12)) EMode(!_m83);
        if (_flavor.Inches && Chance(0.1))
        {
            _inches = !_inches;
            Line(_inches ? "G20" : "G21");
        }
        if (Chance(0.15)) Line("M106", ('S', _random.Next(256)));
        if (Chance(0.1)) Line("M104", ('S', 190 + _random.Next(40)));
        if (Chance(0.05)) Line("G4", ('P', 250));
        if (Chance(0.05) && _flavor.Pauses[0] is var pause) Line(pause);
        if (Chance(0.15) && !RelativeE)
        {
            _sum = Chance(0.7) ? 0 : Around(-5, 5);
            Line("G92", (_e, _sum / UnitOfE));
        }
        if (Chance(0.06))
        {
            _nameX += _x - 7 * Unit;
            _x = 7 * Unit;
            Line("G92", ('X', 7));
        }
        if (Chance(0.05)) Line("M117 G1 X5 text");
        Offsets();
        if (_tools > 1 && Chance(0.25))
        {
            var tool = _random.Next(_tools);
            if (_flavor.PositionOfE == PositionOfERule.PerTool)
            {
                _ofTool[_tool] = _sum;
                _sum = _ofTool[tool];
            }
            if (_flavor.PositionOfE == PositionOfERule.ZeroAtChange && tool != _tool) _sum = 0;
            _tool = tool;
            Line((_flavor.ToolByM6 ? "M6 T" : "T") + tool.ToString(CultureInfo.InvariantCulture));
        }
        if (_flavor.Planes && _flavor.Arcs && Chance(0.05)) Line("G17");
        if (Chance(0.05)) Line("G1", ('F', 900 / (_inches ? 25.4 : 1)));
    }

    // What shifts the head or its coordinates, or retracts by other amounts.
    private void Offsets()
    {
        if (_flavor.HomeOffset != HomeOffsetRule.None && Chance(0.04)) Line("M206", ('Z', -0.1), ('X', Around(-1, 1)));
        if (_flavor.LargestBabystep > 0 && Chance(0.04)) Line("M290", ('Z', Around(0, 0.1)));
        if (_firmware && _flavor.RetractionSettings is RetractionCommands.Marlin or RetractionCommands.RepRapFirmware && Chance(0.1))
            Line("M207", ('S', 1.5), ('F', 2400), ('Z', 0));
        if (_flavor.RetractionSettings == RetractionCommands.Klipper && Chance(0.1)) Line("SET_RETRACTION RETRACT_LENGTH=1.5");
        if (_flavor.RestorePoints || _flavor.SavedPositions && Chance(0.04)) Line("G60");
        if (!_flavor.SavedPositions || !Chance(0.04)) return;
        Line("G60", ('S', 1));
        Line("G61", ('S', 1), ('Z', Chance(0.5) ? 0 : 0.5));
        Line("G61", ('S', 1));
    }

    private void Mode(int code)
    {
        _g91 = _last = code == 91;
        Line("G" + code.ToString(CultureInfo.InvariantCulture));
    }

    private void EMode(bool relative)
    {
        if (_flavor.RelativeE == RelativeERule.OnlyG90G91) return;
        _m83 = _last = relative;
        Line(relative ? "M83" : "M82");
    }

    private void Print()
    {
        double x = Around(0, 50), y = Chance(0.3) ? _y : Around(0, 50);
        var length = Math.Sqrt((x - _x) * (x - _x) + (y - _y) * (y - _y));
        Motion(1, x, y, _z, length * 0.04, Chance(0.3) ? 600 + 300 * _random.Next(5) : 0);
    }

    private void Arc()
    {
        var radius = Around(2, 10);
        var (sin, cos) = Angle.SinCos(Around(0, 360));
        double cx = _x - radius * cos, cy = _y - radius * sin;
        var sweep = Chance(0.15) ? 360 : Around(20, 300);
        var clockwise = Chance(0.5);
        var (s, c) = Angle.SinCos(clockwise ? -sweep : sweep);
        double x = sweep == 360 ? _x : cx + radius * (cos * c - sin * s), y = sweep == 360 ? _y : cy + radius * (sin * c + cos * s);
        Motion(clockwise ? 2 : 3, x, y, _z, radius * sweep / 180 * 1.5 * 0.04, 0, (cx - _x, cy - _y));
    }

    private void Motion(int code, double x, double y, double z, double e, double feed, (double I, double J)? center = null)
    {
        var words = new System.Collections.Generic.List<(char, double)>();
        void Axis(char letter, double to, double from)
        {
            if (Math.Abs(to - from) > 5e-4 || (center is null && Chance(0.1))) words.Add((letter, (_g91 ? to - from : to) / Unit));
        }
        Axis('X', x, _x);
        Axis('Y', y, _y);
        Axis('Z', z, _z);
        if (center is { } c)
        {
            words.Add(('I', c.I / Unit));
            words.Add(('J', c.J / Unit));
        }
        if (e != 0)
        {
            e = Math.Floor(e * 1e5 + 0.5) / 1e5;
            words.Add((_e, (RelativeE ? e : _sum + e) / UnitOfE));
            _sum += e;
        }
        if (feed > 0) words.Add(('F', feed / Unit));
        if (words.Count == 0) return;
        (_x, _y, _z) = (x, y, z);
        var modal = _flavor.ModalMotion != ModalMotionRule.Never && code == _motion && Chance(0.1) && words[0].Item1 is 'X' or 'Y';
        _motion = code;
        var head = modal ? "" : "G" + code.ToString(CultureInfo.InvariantCulture);
        Line(head, words.ToArray());
    }

    private void Comment(string text) => _text.Append(';').Append(text).Append(_lineEnd);

    private void Line(string head, params (char Letter, double Value)[] words)
    {
        var gap = _noSpace ? "" : " ";
        var line = head;
        foreach (var (letter, value) in words)
        {
            var decimals = letter == _e ? 5 : letter == 'F' ? 2 : _inches ? 5 : 3;
            line += (line.Length > 0 ? gap : "") + letter + NumberFormatter.Format(value, decimals);
        }
        if (_lower && !line.StartsWith("M117", StringComparison.Ordinal)) line = line.ToLowerInvariant();
        if (_numbered)
        {
            line = "N" + (++_number).ToString(CultureInfo.InvariantCulture) + " " + line;
            line += "*" + line.Aggregate(0, (sum, c) => sum ^ c).ToString(CultureInfo.InvariantCulture);
        }
        else if (Chance(0.1)) line += " ; note";
        _text.Append(line).Append(_lineEnd);
    }
}
