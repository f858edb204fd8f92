namespace Caterpillar.GCode;

/// <summary>
/// Marks of objects in another notation: EXCLUDE_OBJECT of Klipper, M486 of Marlin, of RepRapFirmware with names. From M624 and M625 of Bambu, too: a mask
/// with a bit for each object, in the order of their labels.
/// </summary>
internal sealed class ObjectMarks(FlavorRules from, FlavorRules to)
{
    private static readonly Regex Name = new(
        @"NAME=('[^']*'|""[^""]*""|\S+)|[A-Z]""([^""]*)""|^M486 A(.+)$", RegexOptions.CultureInvariant | RegexOptions.IgnoreCase);
    private readonly ObjectLabels _labels = new(to.ObjectMarks);
    private bool _counted;
    private int _current = -1;
    private bool _isMasked;

    /// <summary>True if the target has another notation, or none.</summary>
    public bool Changes { get; } = from.ObjectMarks != to.ObjectMarks;

    /// <summary>A line that marks objects, in the notation of the target.</summary>
    public IReadOnlyList<string> Lines(string code)
    {
        var match = Name.Match(code);
        var name = match.Success ? match.Groups.Cast<Group>().Skip(1).First(g => g.Success).Value.Trim('\'', '"') : "";
        if (code.StartsWith("EXCLUDE_OBJECT_DEFINE", StringComparison.OrdinalIgnoreCase)) _labels.NumberOf(name);
        if (code.StartsWith("EXCLUDE_OBJECT_START", StringComparison.OrdinalIgnoreCase)) return Start(_labels.NumberOf(name));
        if (code.StartsWith("EXCLUDE_OBJECT_END", StringComparison.OrdinalIgnoreCase)) return End();
        if (code.StartsWith("M624", StringComparison.OrdinalIgnoreCase)) return Masked(code.Substring(4).Trim());
        if (code.StartsWith("M625", StringComparison.OrdinalIgnoreCase)) return _isMasked ? End() : [];
        if (!code.StartsWith("M486", StringComparison.OrdinalIgnoreCase)) return [];
        var number = Regex.Match(code, @"S\s*(-?\d+)", RegexOptions.CultureInvariant | RegexOptions.IgnoreCase);
        if (!number.Success || !NumberReader.TryParseInt(number.Groups[1].Value, out var index)) return [];
        if (index is < 0 or > 9999) return End();
        _labels.Name(index, name.Length > 0 ? name : null);
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
        _labels.Name(index, null);
        return Start(index);
    }

    // Numbers need their count first.
    private IReadOnlyList<string> Start(int index)
    {
        _current = index;
        IReadOnlyList<string> count = _counted || to.ObjectMarks == ObjectMarking.Names ? [] : _labels.Definitions([]);
        _counted = true;
        return [.. count, .. _labels.Start(index)];
    }

    private IReadOnlyList<string> End() => _current < 0 && to.ObjectMarks == ObjectMarking.Names ? [] : _labels.End(_current);
}
