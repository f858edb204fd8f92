using System;
using System.Collections.Generic;
using System.Globalization;
using System.Linq;
using System.Text;

namespace Caterpillar.Tests.Jobs;

/// <summary>
/// Watches a G-code file as a person beside the printer does: where the head goes, whether it was homed and hot, what is below each extrusion. A small
/// interpreter of lines, which shares no code with the decoder.
/// </summary>
internal sealed class PrinterEye
{
    private const double Cell = 1;
    private static readonly string[] Macros = ["START_PRINT", "PRINT_START"];
    private readonly Dictionary<(int X, int Y), double> _printed = [];
    private readonly double[] _position = new double[3];
    private readonly double[] _shift = new double[3];
    private readonly double _standing;
    private double _e, _retracted, _pull;
    private bool _relative, _relativeE, _firmwareRetracted, _switchedOn, _homed, _stated, _hot, _bead;
    private double _unit = 1;
    private bool _falls;

    /// <param name="text">The file.</param>
    /// <param name="axis">E, A, or M for a switched extruder.</param>
    /// <param name="isMarlin2">G90 and G91 set the mode of E.</param>
    /// <param name="relativeE">Mode of E at the start.</param>
    /// <param name="standing">Height of a part that stands on the bed, mm.</param>
    public PrinterEye(string text, char axis, bool isMarlin2 = false, double standing = 0)
    {
        _standing = standing;
        foreach (var line in text.Split('\n', '\r')) Read(line, axis, isMarlin2);
    }

    /// <summary>What a person would shout, in order, each kind once.</summary>
    public List<string> Alarms { get; } = [];

    /// <summary>Length of extrusions and of those without anything below, mm; material in units of E.</summary>
    public double Printed { get; private set; }

    public double InTheAir { get; private set; }

    public double Material { get; private set; }

    /// <summary>Temperatures that nozzles were told, °C, each once in a row.</summary>
    public List<double> Heat { get; } = [];

    /// <summary>The head rose after the last extrusion, before it went 5 mm across.</summary>
    public bool Lifts { get; private set; }

    /// <summary>The head came straight from above to its first extrusion.</summary>
    public bool CameFromAbove { get; private set; }

    /// <summary>Lowest height of the nozzle before and while it prints, after the height was stated.</summary>
    public double Lowest { get; private set; } = double.PositiveInfinity;

    private double Across { get; set; }

    private void Read(string line, char axis, bool isMarlin2)
    {
        var code = line.Split(';')[0].Trim();
        if (code.Length == 0) return;
        if (code.Length > 5 && !char.IsDigit(code[1]))
        {
            if (Macros.Any(m => code.StartsWith(m, StringComparison.OrdinalIgnoreCase))) _homed = _hot = true;
            if (code.StartsWith("SET_KINEMATIC_POSITION", StringComparison.Ordinal))
                State(Words(code.Substring(code.IndexOf("Z=", StringComparison.Ordinal)).Replace("=", ""))['Z']);
            return;
        }
        var words = Words(code);
        double? Word(char letter) => words.TryGetValue(letter, out var value) ? value : null;
        if (words.ContainsKey('M')) Machine((int)words['M'], Word);
        else if (words.ContainsKey('G')) Motion(words['G'], Word, axis, isMarlin2);
    }

    private static Dictionary<char, double> Words(string code)
    {
        var words = new Dictionary<char, double>();
        for (var at = 0; at < code.Length;)
        {
            var letter = char.ToUpperInvariant(code[at++]);
            var end = at;
            while (end < code.Length && (char.IsDigit(code[end]) || code[end] is '.' or '-' or '+')) end++;
            var isNumber = double.TryParse(code.Substring(at, end - at), NumberStyles.Float, CultureInfo.InvariantCulture, out var value);
            if (char.IsLetter(letter) && !words.ContainsKey(letter)) words[letter] = isNumber ? value : double.NaN;
            at = Math.Max(end, at);
        }
        return words;
    }

    private void Machine(int code, Func<char, double?> word)
    {
        if (code is 104 or 109 && (word('S') ?? word('R') ?? word('P')) is { } celsius) Heats(celsius);
        switch (code)
        {
            case 82 or 83:
                _relativeE = code == 83;
                break;
            case 101 or 103:
                _switchedOn = code == 101;
                break;
            case 109 or 116:
                _hot |= code == 116 || (word('S') ?? word('R') ?? word('P')) > 150;
                break;
            case 104 when word('S') is 0 or null && word('P') is 0 or null:
                _hot = false;
                break;
        }
    }

    private void Motion(double code, Func<char, double?> word, char axis, bool isMarlin2)
    {
        switch (code)
        {
            case 0 or 1 or 2 or 3:
                Move(word, axis);
                break;
            case 10 or 11 when word('P') is null && word('L') is null:
                _firmwareRetracted = code == 10;
                break;
            case 10 when word('S') is { } celsius:
                Heats(celsius);
                break;
            case 20 or 21:
                _unit = code == 20 ? 25.4 : 1;
                break;
            case 28:
                Home(word);
                break;
            case 90 or 91:
                _relative = code == 91;
                if (isMarlin2) _relativeE = _relative;
                break;
            case 92:
                Rename(word, axis);
                break;
        }
    }

    private void Home(Func<char, double?> word)
    {
        bool x = word('X') is not null, y = word('Y') is not null, z = word('Z') is not null;
        if (!x && !y && !z) x = y = z = true;
        if (z && _standing > 0 && !_bead) Alarm("homes Z onto the part");
        if (x) _position[0] = _shift[0] = 0;
        if (y) _position[1] = _shift[1] = 0;
        if (z) _position[2] = _shift[2] = 0;
        _homed |= x && y && (z || _stated);
        if (_standing > 0 && _stated && _position[2] < _standing + 1 && !_bead) Alarm("homes X and Y on the part");
    }

    private void State(double z)
    {
        _position[2] = z;
        _stated = true;
    }

    private void Rename(Func<char, double?> word, char axis)
    {
        if (word(axis) is { } e) _e = e;
        if (word('Z') is { } z && !_homed) State(z);
        else if (word('Z') is { } later) _shift[2] = _position[2] - later;
        if (word('X') is { } x) _shift[0] = _position[0] - x;
        if (word('Y') is { } y) _shift[1] = _position[1] - y;
    }

    private void Move(Func<char, double?> word, char axis)
    {
        var to = new double[3];
        for (var i = 0; i < 3; i++)
        {
            to[i] = word("XYZ"[i]) * _unit is not { } value ? _position[i] : _relative ? _position[i] + value : value + _shift[i];
        }
        var change = word(axis) is not { } e ? 0 : _relativeE || _relative ? e : e - _e;
        _e = word(axis) is null ? _e : _relativeE || _relative ? _e : word(axis)!.Value;
        var length = Math.Sqrt((to[0] - _position[0]) * (to[0] - _position[0]) + (to[1] - _position[1]) * (to[1] - _position[1]));
        var pushed = Math.Max(change - _retracted, 0);
        _retracted = Math.Max(_retracted - change, 0);
        _pull = Math.Max(_pull, _retracted);
        Material += pushed;
        if (length > 1e-6 && (pushed > 0 || (axis == 'M' && _switchedOn))) Print(to, length);
        else Travel(to, length);
        to.CopyTo(_position, 0);
    }

    private void Print(double[] to, double length)
    {
        if (!_bead && !_homed) Alarm("prints before it is homed");
        if (!_hot) Alarm("prints cold");
        if (_firmwareRetracted) Alarm("prints retracted");
        if (to[2] < _standing - 1e-6) Alarm("prints into the part");
        CameFromAbove = _bead ? CameFromAbove : _falls;
        _bead = true;
        Lifts = false;
        Across = 0;
        Printed += length;
        Lowest = Math.Min(Lowest, to[2]);
        var steps = (int)(length / Cell) + 1;
        for (var i = 0; i < steps; i++)
        {
            var share = (i + 0.5) / steps;
            var (x, y) = (_position[0] + (to[0] - _position[0]) * share, _position[1] + (to[1] - _position[1]) * share);
            var z = _position[2] + (to[2] - _position[2]) * share;
            if (!IsHeld(x, y, z)) InTheAir += length / steps;
            var cell = ((int)Math.Floor(x / Cell), (int)Math.Floor(y / Cell));
            _printed[cell] = Math.Max(_printed.TryGetValue(cell, out var top) ? top : 0, z);
        }
    }

    // On the bed, or no more than a thick layer above what is printed around.
    private bool IsHeld(double x, double y, double z)
    {
        const double Thickest = 0.9;
        if (z <= _standing + Thickest) return true;
        var (cx, cy) = ((int)Math.Floor(x / Cell), (int)Math.Floor(y / Cell));
        for (var i = -1; i <= 1; i++)
        {
            for (var j = -1; j <= 1; j++)
            {
                if (_printed.TryGetValue((cx + i, cy + j), out var top) && top > z - Thickest) return true;
            }
        }
        return false;
    }

    private void Travel(double[] to, double length)
    {
        var rise = to[2] - _position[2];
        if (length > 1e-6 || rise > 1e-6) _falls = false;
        if (rise < -1e-6 && length <= 1e-6) _falls = true;
        if (_standing > 0 && _stated && !_bead && to[2] < _standing - 1e-6) Alarm("goes into the part");
        if (!_bead) return;
        if (length > 1e-6 && rise <= 1e-6) Across += length;
        if (rise > 1e-6 && Across <= 5) Lifts = true;
    }

    private void Heats(double celsius)
    {
        if (Heat.LastOrDefault() != celsius) Heat.Add(celsius);
    }

    private void Alarm(string text)
    {
        if (!Alarms.Contains(text)) Alarms.Add(text);
    }

    /// <summary>The text of bytes, one character each.</summary>
    public static string Text(byte[] bytes) => Encoding.GetEncoding(28591).GetString(bytes);
}
