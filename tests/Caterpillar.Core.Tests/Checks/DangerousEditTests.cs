using System;
using System.Collections.Generic;
using System.Globalization;
using System.Linq;
using System.Text;
using Caterpillar.Basics;
using Caterpillar.Checks;
using Caterpillar.Machines;
using NUnit.Framework;

namespace Caterpillar.Tests.Checks;

/// <summary>A good file with a single change that makes it dangerous, by a judge that shares no code with the checks.</summary>
public class DangerousEditTests
{
    private static readonly int Wanted = Rounds.Of(quick: 60, full: 300);
    private static readonly int Missed = Rounds.Of(quick: 0, full: 1);

    [Test]
    public void Of_single_edits_that_are_dangerous_at_most_one_in_300_is_missed()
    {
        var good = Good();
        var setup = new ProfileLibrary().Setup("generic").OrThrow();
        Assert.That(Judge.Why(good), Is.Null, "the file is good");
        Assert.That(Serious(good, setup), Is.Empty, "and passes");
        var random = new Random(2026);
        var (edits, found) = (0, 0);
        var missed = new List<string>();
        for (var tries = 0; edits < Wanted; tries++)
        {
            Assert.That(tries, Is.LessThan(10_000));
            var lines = good.ToList();
            var what = Edit(lines, random);
            if (Judge.Why(lines) is not { } danger) continue;
            edits++;
            if (Serious(lines, setup).Any()) found++;
            else missed.Add(what + ": " + danger);
        }
        TestContext.Progress.WriteLine($"{found} of {edits} dangerous edits are found");
        Assert.That(found, Is.AtLeast(Wanted - Missed), string.Join("\n", missed));
    }

    private static IEnumerable<Diagnostic> Serious(IReadOnlyList<string> lines, PrintSetup setup)
        => PrintCheck.Run(SmallPrint.Decode(Encoding.ASCII.GetBytes(string.Join("\n", lines)), setup), setup)
            .Where(d => d.Severity == Severity.Error || d.Code.StartsWith("file.", StringComparison.Ordinal));

    // Two towers, with a lift between them in each layer, and start and end code.
    private static List<string> Good()
    {
        var lines = new List<string> { "M140 S60", "M104 S210", "G28", "M190 S60", "M109 S210", "G21", "G90", "M83", "G92 E0", "G1 Z5 F600" };
        for (var layer = 1; layer <= 12; layer++)
        {
            var z = Number(0.2 * layer);
            foreach (var x in new[] { 60, 100 })
            {
                lines.Add("G1 E-0.8 F2100");
                lines.Add($"G0 Z{Number(0.2 * layer + 3)} F600");
                lines.Add($"G0 X{x} Y80 F9000");
                lines.Add($"G0 Z{z} F600");
                lines.Add("G1 E0.8 F2100");
                lines.Add($"G1 X{x + 20} E0.66 F1800");
                lines.Add("G1 Y100 E0.66");
                lines.Add($"G1 X{x} E0.66");
                lines.Add("G1 Y80 E0.66");
            }
        }
        lines.AddRange(["G1 E-2 F2100", "G1 Z20 F600", "G1 X0 Y220 F6000", "M107", "M104 S0", "M140 S0", "M84"]);
        return lines;
    }

    private static string Edit(List<string> lines, Random random)
    {
        var at = random.Next(lines.Count);
        var old = lines[at];
        switch (random.Next(5))
        {
            case 0:
                lines.RemoveAt(at);
                return $"{at}: without {old}";
            case 1:
                string[] inserts = ["G91", "G20", "M82", "G92 Z10", "G92 X50", "G1 Z0.1", "G1 X-20", "G1 Y230", "M104 S0", "M104 S100", "M104 S330",
                    "M140 S150", "T1",
                    "G1 E400", "G1 E-400", "G1 Z-0.5", "G0 X90 Y90 Z0.3", "G0 X110 Y60"];
                lines.Insert(at, inserts[random.Next(inserts.Length)]);
                return $"{at}: {lines[at]}";
            default:
                var words = old.Split(' ');
                var word = random.Next(words.Length);
                var text = words[word];
                if (!double.TryParse(text.Substring(1), NumberStyles.Float, CultureInfo.InvariantCulture, out var value)) return "nothing";
                words[word] = text[0] + Number(random.Next(6) switch { 0 => -value, 1 => value * 10, 2 => value / 10, 3 => value + 150, 4 => 0,
                    _ => value - 1.5 });
                lines[at] = string.Join(" ", words);
                return $"{at}: {old} -> {lines[at]}";
        }
    }

    private static string Number(double value) => value.ToString("0.###", CultureInfo.InvariantCulture);

    /// <summary>Follows a file as a simple machine would: where it goes, how hot it is, what it lays down on a grid of 1 mm.</summary>
    private sealed class Judge
    {
        private readonly Dictionary<(int, int), double> _tops = [];
        private readonly Dictionary<char, double> _at = new() { ['X'] = 0, ['Y'] = 0, ['Z'] = 0, ['E'] = 0 };
        private readonly Dictionary<char, double> _shift = new() { ['X'] = 0, ['Y'] = 0, ['Z'] = 0 };
        private double _nozzle, _bed, _speed = 25, _retracted, _standing;
        private bool _relative, _relativeE, _homed, _inches;

        public static string? Why(IReadOnlyList<string> lines)
        {
            var judge = new Judge();
            foreach (var line in lines)
            {
                if (judge.Line(line) is { } danger) return line + ": " + danger;
            }
            return judge._nozzle > 0 ? "nozzle left on" : judge._bed > 0 ? "bed left on" : null;
        }

        private string? Line(string line)
        {
            var words = line.Split(' ');
            var has = new Dictionary<char, double>();
            foreach (var word in words.Skip(1)) has[word[0]] = double.Parse(word.Substring(1), CultureInfo.InvariantCulture);
            switch (words[0])
            {
                case "M104" or "M109":
                    _nozzle = has.TryGetValue('S', out var s) ? s : _nozzle;
                    return _nozzle > 300 ? "too hot" : null;
                case "M140" or "M190":
                    _bed = has.TryGetValue('S', out var b) ? b : _bed;
                    return _bed > 120 ? "bed too hot" : null;
                case "G28":
                    _homed = true;
                    foreach (var axis in "XYZ") (_at[axis], _shift[axis]) = (0, 0);
                    return null;
                case "G90": (_relative, _relativeE) = (false, false); return null;
                case "G91": (_relative, _relativeE) = (true, true); return null;
                case "M82": _relativeE = false; return null;
                case "M83": _relativeE = true; return null;
                case "G20": _inches = true; return null;
                case "G21": _inches = false; return null;
                case "T1": return "no such tool";
                case "G92":
                    foreach (var (axis, value) in has.Select(p => (p.Key, p.Value * Unit)))
                    {
                        if (axis != 'E') _shift[axis] += _at[axis] - value;
                        _at[axis] = value;
                    }
                    return null;
                case "G0" or "G1": return Move(has);
                default: return null;
            }
        }

        private double Unit => _inches ? 25.4 : 1;

        private string? Move(Dictionary<char, double> has)
        {
            if (has.TryGetValue('F', out var f) && f > 0) _speed = f * Unit / 60;
            var from = Machine();
            var e = 0.0;
            foreach (var (axis, value) in has.Where(p => p.Key != 'F').Select(p => (p.Key, p.Value * Unit)))
            {
                var target = (axis == 'E' ? _relativeE : _relative) ? _at[axis] + value : value;
                if (axis == 'E') e = target - _at['E'];
                _at[axis] = target;
            }
            var to = Machine();
            if (to.X < -0.01 || to.X > 220.01 || to.Y < -0.01 || to.Y > 220.01 || to.Z > 250.01) return "outside";
            if (to.Z < -0.01) return "below the bed";
            if (e > 0 && _nozzle < 170) return "cold";
            var length = Math.Sqrt(Math.Pow(to.X - from.X, 2) + Math.Pow(to.Y - from.Y, 2) + Math.Pow(to.Z - from.Z, 2));
            var fills = Math.Min(Math.Max(e, 0), Math.Max(_retracted, 0));
            _retracted -= e;
            if (_retracted < 0) _retracted = 0;
            var volume = (e - fills) * 2.405;
            if (length < 1e-9)
            {
                _standing += e * 2.405;
                return Math.Abs(_standing) > 510 ? "too much in place" : null;
            }
            _standing = 0;
            var most = Math.Min(_speed, 300);
            if (Math.Abs(to.Z - from.Z) > 1e-9) most = Math.Min(most, 12 * length / Math.Abs(to.Z - from.Z));
            if (volume > 0 && volume / length * most > 12.5) return "too much flow";
            if (volume > 0 && !_homed) return "not homed";
            return Through(from, to, length, volume > 0.001);
        }

        private string? Through((double X, double Y, double Z) from, (double X, double Y, double Z) to, double length, bool prints)
        {
            var steps = (int)Math.Ceiling(length / 0.25);
            var laid = new List<(int, int, double)>();
            for (var k = 1; k <= steps; k++)
            {
                var t = (double)k / steps;
                var (x, y, z) = (from.X + (to.X - from.X) * t, from.Y + (to.Y - from.Y) * t, from.Z + (to.Z - from.Z) * t);
                // Away from its own corners, and clearly through the middle of a wall.
                var far = Math.Abs(x - from.X) + Math.Abs(y - from.Y) > 3;
                if (far && _tops.TryGetValue(Cell(x, y), out var top) && top > z + 0.3) return "through the print";
                if (prints) laid.Add((Cell(x, y).Item1, Cell(x, y).Item2, z));
            }
            foreach (var (column, row, z) in laid)
                _tops[(column, row)] = _tops.TryGetValue((column, row), out var before) ? Math.Max(before, z) : z;
            return null;
        }

        // Cells of a quarter of a millimeter around the axis of an extrusion.
        private static (int, int) Cell(double x, double y) => ((int)Math.Round(x * 4), (int)Math.Round(y * 4));

        private (double X, double Y, double Z) Machine() => (_at['X'] + _shift['X'], _at['Y'] + _shift['Y'], _at['Z'] + _shift['Z']);
    }
}
