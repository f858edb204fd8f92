using System.Text;

namespace Caterpillar.Machines;

/// <summary>
/// Names in braces that ExtruderTurtle fills in in its headers (<c>setup</c>, with Python's <c>str.format</c>), and their replacements in templates.
/// </summary>
internal static class HeaderNames
{
    private static readonly (string Name, string Formula)[] Names =
    [
        ("x", "(bed_min_x_mm + bed_max_x_mm) / 2"),
        ("y", "(bed_min_y_mm + bed_max_y_mm) / 2"),
        ("z", "first_layer_height_mm"),
        ("feedrate", "print_speed_mm_s * 60"),
        ("hotend_temp", "start_nozzle_temperature_c"),
        ("bed_temp", "bed_temperature_c"),
    ];

    /// <summary>
    /// The text as a line of a template. Other text in braces keeps literal braces and is added to <paramref name="unknown"/> with its column from 1.
    /// </summary>
    public static string ToTemplate(string text, List<string> used, List<(string Name, int Column)> unknown)
    {
        if (text.IndexOfAny(['{', '}']) < 0) return text;
        var result = new StringBuilder();
        for (var at = 0; at < text.Length; at++)
        {
            var c = text[at];
            if (c is not ('{' or '}'))
            {
                result.Append(c);
                continue;
            }
            if (at + 1 < text.Length && text[at + 1] == c)
            {
                result.Append(c).Append(c);
                at++;
                continue;
            }
            var end = c == '{' ? text.IndexOf('}', at) : -1;
            var inside = end < 0 ? "" : text.Substring(at + 1, end - at - 1);
            // A format such as {x:.2f} or {x!r} is Python's; templates format numbers themselves.
            var name = inside.Split([':', '!'], 2)[0].Trim();
            var known = Array.Find(Names, n => n.Name == name);
            if (known.Name is null)
            {
                unknown.Add((end < 0 ? c.ToString() : "{" + inside + "}", at + 1));
                result.Append(c).Append(c);
                continue;
            }
            used.Add(name);
            result.Append('{').Append(known.Formula).Append('}');
            at = end;
        }
        return result.ToString();
    }
}
