using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using System.Text;

namespace Caterpillar.Cli.Tests;

/// <summary>Command lines as shells read them: quotes, comments, continued lines, and output to a file.</summary>
internal static class CommandLines
{
    /// <summary>The words of a line, and the file to which its output goes.</summary>
    public static (string[] Words, string? Output) Split(string line)
    {
        var words = new List<string>();
        var word = new StringBuilder();
        bool isWord = false;
        char quote = '\0';
        foreach (var c in line + " ")
        {
            if (quote != '\0')
            {
                if (c == quote) quote = '\0';
                else word.Append(c);
            }
            else if (c is '"' or '\'')
            {
                quote = c;
                isWord = true;
            }
            else if (c == '#' && !isWord)
            {
                break;
            }
            else if (c is ' ' or '\t')
            {
                if (isWord) words.Add(word.ToString());
                word.Clear();
                isWord = false;
            }
            else
            {
                word.Append(c);
                isWord = true;
            }
        }
        if (quote != '\0') throw new FormatException("A quote is not closed: " + line);
        var to = words.IndexOf(">");
        return to < 0 ? ([.. words], null) : ([.. words.Take(to)], words[to + 1]);
    }

    /// <summary>The lines in the code blocks of a Markdown page that call the program.</summary>
    public static IEnumerable<string> InPage(string file)
    {
        var isCode = false;
        var continued = "";
        foreach (var line in File.ReadLines(file).Select(l => l.Trim()))
        {
            if (line.StartsWith("```", StringComparison.Ordinal))
            {
                isCode = !isCode;
                continue;
            }
            if (!isCode) continue;
            var whole = continued + line;
            continued = "";
            if (whole.EndsWith('\\')) continued = whole[..^1] + " ";
            else if (whole.StartsWith("caterpillar ", StringComparison.Ordinal)) yield return whole;
        }
    }
}
