using System.Text.RegularExpressions;
using Caterpillar.Flavors;

namespace Caterpillar.GCode;

/// <summary>
/// Marks of objects in another notation: EXCLUDE_OBJECT of Klipper, M486 of Marlin, of RepRapFirmware with names. From M624 and M625 of Bambu, too: a mask
/// with a bit for each object, in the order of their labels.
/// </summary>
internal sealed class ObjectMarks(FlavorRules from, FlavorRules to)
{
    private static readonly Regex Name = new(
        @"NAME=('[^']*'|""[^""]*""|\S+)|[A-Z]""([^""]*)""|^M486 A(.+)$", RegexOptions.CultureInvariant | RegexOptions.IgnoreCase);
    private readonly List<string> _names = [];
    private bool _counted;
    private string _current = "";
    private bool _isMasked;

    /// <summary>True if the target has another notation, or none.</summary>
    public bool Changes { get; } = from.ObjectMarks != to.ObjectMarks;

    /// <summary>A line that marks objects, in the notation of the target.</summary>
    public IReadOnlyList<string> Lines(string code)
    {
        var match = Name.Match(code);
        var name = match.Success ? match.Groups.Cast<Group>().Skip(1).First(g => g.Success).Value.Trim('\'', '"') : "";
        if (code.StartsWith("EXCLUDE_OBJECT_DEFINE", StringComparison.OrdinalIgnoreCase)) IndexOf(name);
        if (code.StartsWith("EXCLUDE_OBJECT_START", StringComparison.OrdinalIgnoreCase)) return Start(IndexOf(name));
        if (code.StartsWith("EXCLUDE_OBJECT_END", StringComparison.OrdinalIgnoreCase)) return End();
        if (code.StartsWith("M624", StringComparison.OrdinalIgnoreCase)) return Masked(code.Substring(4).Trim());
        if (code.StartsWith("M625", StringComparison.OrdinalIgnoreCase)) return _isMasked ? End() : [];
        if (!code.StartsWith("M486", StringComparison.OrdinalIgnoreCase)) return [];
        var number = Regex.Match(code, @"S\s*(-?\d+)", RegexOptions.CultureInvariant | RegexOptions.IgnoreCase);
        if (!number.Success || !NumberReader.TryParseInt(number.Groups[1].Value, out var index)) return [];
        if (index is < 0 or > 9999) return End();
        Reserve(index);
        if (name.Length > 0) _names[index] = Regex.Replace(name, @"\W+", "_");
        return Start(index);
    }

    private IReadOnlyList<string> Masked(string mask)
    {
        var bits = Regex.IsMatch(mask, "^[A-Za-z0-9+/]{11}=$", RegexOptions.CultureInvariant) ? BitConverter.ToUInt64(Convert.FromBase64String(mask), 0) : 0;
        // What belongs to several objects belongs to none.
        _isMasked = bits > 0 && (bits & (bits - 1)) == 0;
        if (!_isMasked) return [];
        var index = 0;
        while (bits >> index != 1) index++;
        Reserve(index);
        return Start(index);
    }

    private void Reserve(int index)
    {
        while (_names.Count <= index) _names.Add("object_" + NumberFormatter.Format(_names.Count));
    }

    private int IndexOf(string name)
    {
        var index = _names.IndexOf(name);
        if (index < 0) _names.Add(name);
        return index < 0 ? _names.Count - 1 : index;
    }

    private IReadOnlyList<string> Start(int index)
    {
        var number = NumberFormatter.Format(index);
        _current = _names[index];
        if (to.ObjectMarks == ObjectMarking.Names) return ["EXCLUDE_OBJECT_START NAME=" + _current];
        if (to.ObjectMarks == ObjectMarking.None) return [];
        var line = to.ObjectMarks == ObjectMarking.NumbersWithNames ? $"M486 S{number} A\"{_current}\"" : "M486 S" + number;
        if (_counted) return [line];
        _counted = true;
        return ["M486 T" + NumberFormatter.Format(_names.Count), line];
    }

    private IReadOnlyList<string> End() => to.ObjectMarks switch
    {
        ObjectMarking.None => [],
        ObjectMarking.Names => _current.Length > 0 ? ["EXCLUDE_OBJECT_END NAME=" + _current] : [],
        _ => ["M486 S-1"],
    };
}
