namespace Caterpillar.Machines;

/// <summary>Values as in JSON: text, double, bool, and lists of these.</summary>
internal static class RawValues
{
    public static string Range(double min, double max) => NumberFormatter.Shortest(min) + " to " + NumberFormatter.Shortest(max);

    public static double[]? Numbers(object raw, int count)
        => raw is IReadOnlyList<object> list && list.Count == count && list.All(i => i is double) ? list.Cast<double>().ToArray() : null;

    public static object List(params double[] values) => values.Cast<object>().ToArray();

    /// <summary>Numbers separated by commas, spaces or x, with or without brackets; null if one is not a number.</summary>
    public static object? ParseNumbers(string text)
    {
        var numbers = Unbracketed(text).Split([',', ' ', 'x', '×'], StringSplitOptions.RemoveEmptyEntries)
            .Select(part => NumberReader.TryParse(part, out var number) ? (object)number : null).ToArray();
        return numbers.Contains(null) ? null : numbers;
    }

    /// <summary>Rows of numbers: separated by semicolons, or in brackets as in a profile, <c>[[1, 2], [3, 4]]</c>.</summary>
    public static object? ParseRows(string text)
    {
        var inner = text.Trim();
        if (IsBracketed(inner) && (inner == "[]" || IsBracketed(inner.Substring(1, inner.Length - 2).Trim()))) inner = inner.Substring(1, inner.Length - 2);
        var rows = new List<object>();
        foreach (var row in Regex.Replace(inner, @"\]\s*,", "];").Split(';'))
        {
            if (row.Trim().Length == 0) continue;
            if (ParseNumbers(row) is not { } numbers) return null;
            rows.Add(numbers);
        }
        return rows.ToArray();
    }

    /// <summary>A value as text that the formats parse.</summary>
    public static string Text(object raw) => raw switch
    {
        double number => NumberFormatter.Shortest(number),
        bool flag => flag ? "true" : "false",
        IReadOnlyList<object> lines when lines.Count > 0 && lines[0] is string => string.Join("\n", lines),
        IReadOnlyList<object> { Count: 0 } => "",
        IReadOnlyList<object> list => "[" + string.Join(", ", list.Select(Text)) + "]",
        _ => (string)raw,
    };

    /// <summary>A text without the brackets around it, if it has any.</summary>
    public static string Unbracketed(string text)
    {
        text = text.Trim();
        return IsBracketed(text) ? text.Substring(1, text.Length - 2) : text;
    }

    private static bool IsBracketed(string text) => text.Length >= 2 && text[0] == '[' && text[text.Length - 1] == ']';
}
