using System;
using System.Globalization;
using System.IO;
using System.Linq;
using System.Security.Cryptography;
using System.Text;
using System.Text.RegularExpressions;

namespace Caterpillar.GH.Tests.Examples;

/// <summary>G-code of the sample definitions as the golden files keep it. The tests in Rhino compare with the same files.</summary>
internal static class GoldenCode
{
    /// <summary>Without the setup and the version; of long files the lines at both ends, and what tells the rest from others.</summary>
    public static string Short(string code)
    {
        const int Longest = 100_000, Lines = 100;
        code = WithoutSetup(code);
        if (code.Length <= Longest) return code;
        var lines = code.Split('\n');
        using var hash = SHA256.Create();
        var digest = string.Concat(hash.ComputeHash(Encoding.UTF8.GetBytes(code)).Select(b => b.ToString("x2", CultureInfo.InvariantCulture)));
        return $"; {lines.Length} lines, SHA-256 {digest}\n{string.Join("\n", lines.Take(Lines))}\n...\n{string.Join("\n", lines.Skip(lines.Length - Lines))}";
    }

    /// <summary>The golden file of a definition.</summary>
    public static string Read(string repository, string name)
        => File.ReadAllText(Path.Combine(repository, "tests", "Caterpillar.GH.Tests", "Examples", "Golden", name + ".gcode")).Replace("\r\n", "\n");

    /// <summary>One line on how G-code compares with a golden file: "same", or the first line that differs.</summary>
    public static string Compared(string code, string golden)
    {
        string[] found = Short(code).Split('\n'), kept = golden.Split('\n');
        for (var i = 0; i < Math.Min(found.Length, kept.Length); i++)
        {
            if (found[i] != kept[i]) return $"differs: line {i + 1} is \"{found[i]}\" instead of \"{kept[i]}\"";
        }
        return found.Length == kept.Length ? "same" : $"differs: {found.Length} lines instead of {kept.Length}";
    }

    // The setup in a file has every key, and its first line the version: files would change with each of them.
    private static string WithoutSetup(string code)
    {
        const string Begin = "; caterpillar_config = begin", End = "; caterpillar_config = end\n";
        var begin = code.IndexOf(Begin, StringComparison.Ordinal);
        if (begin >= 0) code = code.Remove(begin, code.IndexOf(End, begin, StringComparison.Ordinal) + End.Length - begin);
        return Regex.Replace(code, @"by Caterpillar [\d.]+ on", "by Caterpillar on");
    }
}
