using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using System.Text.RegularExpressions;
using Caterpillar.Tests;

namespace Caterpillar.Cli.Tests;

/// <summary>A fenced block of a page of the manual: its language ("" where the page states none) and its text.</summary>
public sealed partial record CodeBlock(string Page, int Number, string Language, string Text)
{
    public static IEnumerable<CodeBlock> OfManual()
        => Directory.EnumerateFiles(Path.Combine(TestData.Repository, "docs"), "*.md", SearchOption.AllDirectories)
            .Append(Path.Combine(TestData.Repository, "README.md")).OrderBy(f => f, StringComparer.Ordinal).SelectMany(OfPage);

    /// <summary>True for a block with command lines of the program.</summary>
    public bool CallsTheProgram => Text.Split('\n').Any(line => line.StartsWith("caterpillar ", StringComparison.Ordinal));

    public override string ToString() => $"{Page} {Number}";

    private static IEnumerable<CodeBlock> OfPage(string file)
    {
        var text = File.ReadAllText(file).Replace("\r\n", "\n", StringComparison.Ordinal);
        return Fence().Matches(text).Select((m, i)
            => new CodeBlock(Path.GetFileName(file), i + 1, m.Groups[2].Value, Flush(m.Groups[3].Value, m.Groups[1].Value)));
    }

    private static string Flush(string text, string margin)
        => margin.Length == 0 ? text : text.Replace("\n" + margin, "\n", StringComparison.Ordinal)[margin.Length..];

    [GeneratedRegex("^( *)```([a-z]*)\n(.*?)^ *```$", RegexOptions.Singleline | RegexOptions.Multiline)]
    private static partial Regex Fence();
}
