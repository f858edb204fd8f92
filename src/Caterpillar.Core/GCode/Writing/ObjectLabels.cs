namespace Caterpillar.GCode;

/// <summary>
/// Commands that mark the objects of a print, so that one of them can be canceled: EXCLUDE_OBJECT of Klipper, M486 of Marlin, of RepRapFirmware with names.
/// Objects are numbered in the order of their first use.
/// </summary>
internal sealed class ObjectLabels(ObjectMarking marking)
{
    // RepRapFirmware keeps no more.
    private const int LongestName = 100;
    private readonly List<string> _names = [];
    private readonly List<string> _labels = [];

    /// <summary>True if only comments can tell the names.</summary>
    public bool LacksNames => marking is ObjectMarking.None or ObjectMarking.Numbers;

    /// <summary>The number of an object, which is added if it is new.</summary>
    public int NumberOf(string name)
    {
        var known = _names.IndexOf(name);
        if (known < 0) _names.Add(name);
        return known < 0 ? _names.Count - 1 : known;
    }

    /// <summary>Names an object that has a number.</summary>
    public void Name(int number, string? name)
    {
        while (_names.Count <= number) _names.Add("object_" + NumberFormatter.Format(_names.Count));
        if (name is null || name == _names[number]) return;
        _names[number] = name;
        _labels.RemoveRange(Math.Min(number, _labels.Count), Math.Max(_labels.Count - number, 0));
    }

    /// <summary>The lines at the head of a file, with an outline of each object in mm, in the order of the numbers.</summary>
    public IReadOnlyList<string> Definitions(IEnumerable<IReadOnlyList<Vec3>> outlines) => marking switch
    {
        ObjectMarking.None => [],
        ObjectMarking.Names => [.. outlines.Select((outline, number) => $"EXCLUDE_OBJECT_DEFINE NAME={Label(number)}{Place(outline)}")],
        _ => _names.Count == 0 ? [] : ["M486 T" + NumberFormatter.Format(_names.Count)],
    };

    /// <summary>The lines before the moves of an object.</summary>
    public IReadOnlyList<string> Start(int number) => marking switch
    {
        ObjectMarking.None => [],
        ObjectMarking.Names => ["EXCLUDE_OBJECT_START NAME=" + Label(number)],
        ObjectMarking.NumbersWithNames => [$"M486 S{NumberFormatter.Format(number)} A\"{Label(number)}\""],
        _ => ["M486 S" + NumberFormatter.Format(number)],
    };

    /// <summary>The lines after the moves of an object.</summary>
    public IReadOnlyList<string> End(int number) => marking switch
    {
        ObjectMarking.None => [],
        ObjectMarking.Names => ["EXCLUDE_OBJECT_END NAME=" + Label(number)],
        _ => ["M486 S-1"],
    };

    // Klipper splits words at spaces and ignores case: objects whose names become the same get numbers.
    private string Label(int number)
    {
        while (_labels.Count <= number)
        {
            var word = Regex.Replace(_names[_labels.Count], @"\W+", "_", RegexOptions.CultureInvariant).Trim('_');
            if (word.Length is 0 or > LongestName) word = word.Length == 0 ? "object" : word.Substring(0, LongestName);
            var label = word;
            for (var k = 2; _labels.Contains(label, StringComparer.OrdinalIgnoreCase); k++) label = word + "_" + NumberFormatter.Format(k);
            _labels.Add(label);
        }
        return _labels[number];
    }

    /// <summary>The words for an outline.</summary>
    public static string Place(IReadOnlyList<Vec3> outline)
    {
        if (outline.Count == 0) return "";
        var box = Bounds.Empty;
        foreach (var point in outline) box = box.Include(point);
        return $" CENTER={Point(box.Center)} POLYGON=[{string.Join(",", outline.Select(p => "[" + Point(p) + "]"))}]";
    }

    private static string Point(Vec3 point) => NumberFormatter.Format(point.X, 3) + "," + NumberFormatter.Format(point.Y, 3);
}
