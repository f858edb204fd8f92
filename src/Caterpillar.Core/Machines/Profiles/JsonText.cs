using Caterpillar.Basics;
using System.Collections.Generic;
using System.Globalization;
using System.Text;

namespace Caterpillar.Machines;

/// <summary>Writes raw values as JSON text: numbers by <see cref="NumberFormatter"/>, one entry per line in objects, lists of numbers on one line.</summary>
internal static class JsonText
{
    public static string Object(IEnumerable<KeyValuePair<string, object>> entries)
    {
        var text = new StringBuilder();
        Append(text, entries, 0);
        return text.Append('\n').ToString();
    }

    public static string Quoted(string value)
    {
        var text = new StringBuilder(value.Length + 2).Append('"');
        foreach (var c in value)
        {
            if (c is '"' or '\\') text.Append('\\').Append(c);
            else if (c == '\n') text.Append("\\n");
            else if (c == '\t') text.Append("\\t");
            else if (c < ' ') text.Append("\\u").Append(((int)c).ToString("x4", CultureInfo.InvariantCulture));
            else text.Append(c);
        }
        return text.Append('"').ToString();
    }

    private static void Append(StringBuilder text, IEnumerable<KeyValuePair<string, object>> entries, int indent)
    {
        text.Append('{');
        var first = true;
        foreach (var entry in entries)
        {
            if (!first) text.Append(',');
            first = false;
            Line(text, indent + 2).Append(Quoted(entry.Key)).Append(": ");
            Append(text, entry.Value, indent + 2);
        }
        if (!first) Line(text, indent);
        text.Append('}');
    }

    private static void Append(StringBuilder text, object value, int indent)
    {
        switch (value)
        {
            case string s: text.Append(Quoted(s)); break;
            case bool b: text.Append(b ? "true" : "false"); break;
            case double d: text.Append(RawValues.Number(d)); break;
            case IEnumerable<KeyValuePair<string, object>> entries: Append(text, entries, indent); break;
            case IReadOnlyList<object> list: Append(text, list, indent); break;
        }
    }

    private static void Append(StringBuilder text, IReadOnlyList<object> list, int indent)
    {
        var lines = list.Count > 0 && list[0] is string;
        text.Append('[');
        for (var i = 0; i < list.Count; i++)
        {
            if (i > 0) text.Append(lines ? "," : ", ");
            if (lines) Line(text, indent + 2);
            Append(text, list[i], indent + 2);
        }
        if (lines) Line(text, indent);
        text.Append(']');
    }

    private static StringBuilder Line(StringBuilder text, int indent) => text.Append('\n').Append(' ', indent);
}
