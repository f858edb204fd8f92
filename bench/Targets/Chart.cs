using System;
using System.Collections.Generic;
using System.Globalization;
using System.IO;
using System.Linq;
using System.Text;

namespace Caterpillar.Bench;

/// <summary>Bars of what each job takes of what it may take, on a logarithmic scale, as SVG.</summary>
internal static class Chart
{
    private const int Width = 900;
    private const int Left = 430;
    private const int Right = 120;
    private const int Step = 24;
    private const int Top = 46;
    private const double Least = 0.02;
    private const double Most = 10;

    /// <summary>Makes the chart of the table of targets in a file of results, beside it.</summary>
    public static void Make(string results)
    {
        var table = File.ReadLines(results).SkipWhile(l => l != "## Targets").Skip(1).TakeWhile(l => !l.StartsWith("## ", StringComparison.Ordinal));
        var targets = table.Select(Target.OfRow).OfType<Target>().Where(t => t.HasTarget).ToArray();
        File.WriteAllText(Path.Combine(Path.GetDirectoryName(Path.GetFullPath(results))!, "targets.svg"), Of(targets));
    }

    private static string Of(IReadOnlyList<Target> targets)
    {
        var height = Top + Step * targets.Count + 20;
        var svg = new StringBuilder();
        svg.Append(Inv($"<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {Width} {height}\" font-family=\"sans-serif\" font-size=\"12\">\n"));
        svg.Append(Inv($"<rect width=\"{Width}\" height=\"{height}\" fill=\"#ffffff\"/>\n"));
        svg.Append("<text x=\"12\" y=\"20\" font-size=\"14\" fill=\"#222222\">Measured, as a part of what is allowed (shorter is better)</text>\n");
        foreach (var mark in new[] { 0.1, 0.5, 1, 2, 5 })
        {
            var x = At(mark);
            svg.Append(Inv($"<line x1=\"{x:0.#}\" y1=\"{Top - 10}\" x2=\"{x:0.#}\" y2=\"{height - 16}\" stroke=\"{(mark == 1 ? "#222222" : "#cccccc")}\"/>\n"));
            svg.Append(Inv($"<text x=\"{x:0.#}\" y=\"{Top - 14}\" text-anchor=\"middle\" fill=\"#555555\">{mark}</text>\n"));
        }
        for (var i = 0; i < targets.Count; i++)
        {
            var (target, y) = (targets[i], Top + Step * i);
            var end = At(target.Share);
            svg.Append(Inv($"<text x=\"{Left - 8}\" y=\"{y + 13}\" text-anchor=\"end\" fill=\"#222222\">{Plain(target.Job)}</text>\n"));
            svg.Append(Inv($"<rect x=\"{Left}\" y=\"{y}\" width=\"{end - Left:0.#}\" height=\"16\" fill=\"{(target.IsMet ? "#2a9d5c" : "#d1495b")}\"/>\n"));
            svg.Append(Inv($"<text x=\"{end + 5:0.#}\" y=\"{y + 13}\" fill=\"#222222\">{target.Text(target.Measured)}</text>\n"));
        }
        return svg.Append("</svg>\n").ToString();
    }

    private static double At(double share)
        => Left + (Width - Left - Right) * Math.Log(Math.Clamp(share, Least, Most) / Least) / Math.Log(Most / Least);

    private static string Plain(string text)
    {
        text = text.Replace("`", "", StringComparison.Ordinal).Replace("&", "&amp;", StringComparison.Ordinal).Replace("<", "&lt;", StringComparison.Ordinal);
        return text.Length > 66 ? text[..65] + "…" : text;
    }

    private static string Inv(FormattableString text) => FormattableString.Invariant(text);
}
