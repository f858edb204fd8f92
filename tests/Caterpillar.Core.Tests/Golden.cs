using System;
using System.Globalization;
using System.IO;
using System.Linq;
using System.Security.Cryptography;
using System.Text;
using System.Text.RegularExpressions;
using System.Threading;
using NUnit.Framework;

namespace Caterpillar.Tests;

/// <summary>
/// Compares whole outputs with files in <c>tests/Caterpillar.Core.Tests/GoldenFiles</c>. Small outputs are kept whole, large ones as a digest: size, SHA-256,
/// first and last lines.
/// <c>CATERPILLAR_RENEW=1</c> rewrites the files.
/// </summary>
internal static class Golden
{
    private const int KeptWhole = 40_000;

    private static string Folder => Path.Combine(TestData.Repository, "tests", "Caterpillar.Core.Tests", "GoldenFiles");

    public static void Check(string name, byte[] actual)
    {
        var file = Path.Combine(Folder, name.Replace('/', Path.DirectorySeparatorChar));
        actual = WithoutSetup(actual);
        var expected = actual.Length <= KeptWhole ? actual : Digest(actual);
        if (Environment.GetEnvironmentVariable("CATERPILLAR_RENEW") == "1")
        {
            Directory.CreateDirectory(Path.GetDirectoryName(file)!);
            File.WriteAllBytes(file, expected);
            return;
        }
        Assert.That(File.Exists(file), Is.True, $"There is no golden file {name}; CATERPILLAR_RENEW=1 writes it.");
        if (File.ReadAllBytes(file).SequenceEqual(expected)) return;
        var kept = Path.Combine(Path.GetTempPath(), "caterpillar-golden", name.Replace('/', Path.DirectorySeparatorChar));
        Directory.CreateDirectory(Path.GetDirectoryName(kept)!);
        File.WriteAllBytes(kept, actual);
        Assert.That(Text(expected), Is.EqualTo(Text(File.ReadAllBytes(file))), $"{name} differs; the whole output is in {kept}.");
        Assert.Fail($"{name} differs in its bytes; the whole output is in {kept}.");
    }

    /// <summary>Runs code under a culture.</summary>
    public static T Under<T>(string culture, Func<T> code)
    {
        var before = Thread.CurrentThread.CurrentCulture;
        var defaultBefore = CultureInfo.DefaultThreadCurrentCulture;
        try
        {
            // Worker threads too.
            CultureInfo.DefaultThreadCurrentCulture = Thread.CurrentThread.CurrentCulture = new CultureInfo(culture);
            return code();
        }
        finally
        {
            Thread.CurrentThread.CurrentCulture = before;
            CultureInfo.DefaultThreadCurrentCulture = defaultBefore;
        }
    }

    // The setup in a file has every key, and its first line the version: files would change with each of them.
    private static byte[] WithoutSetup(byte[] output)
    {
        const string Begin = "; caterpillar_config = begin\n", End = "; caterpillar_config = end\n";
        var text = Text(output);
        var begin = text.IndexOf(Begin, StringComparison.Ordinal);
        if (begin < 0) return output;
        var end = text.IndexOf(End, begin, StringComparison.Ordinal) + End.Length;
        return Encoding.GetEncoding(28591).GetBytes(Regex.Replace(text.Remove(begin, end - begin), @"by Caterpillar [\d.]+ on", "by Caterpillar on"));
    }

    private static byte[] Digest(byte[] output)
    {
        using var sha = SHA256.Create();
        var hash = string.Concat(sha.ComputeHash(output).Select(b => b.ToString("x2", CultureInfo.InvariantCulture)));
        var lines = Text(output).Split('\n');
        var digest = new StringBuilder();
        digest.Append("bytes ").Append(output.Length.ToString(CultureInfo.InvariantCulture)).Append('\n');
        digest.Append("lines ").Append(lines.Length.ToString(CultureInfo.InvariantCulture)).Append('\n');
        digest.Append("sha256 ").Append(hash).Append("\n\n");
        foreach (var line in lines.Take(60)) digest.Append(line).Append('\n');
        digest.Append("...\n");
        // Every thousandth line, so that a difference shows where it begins.
        for (var i = 1000; i < lines.Length - 30; i += 1000) digest.Append(lines[i]).Append('\n');
        digest.Append("...\n");
        foreach (var line in lines.Skip(Math.Max(60, lines.Length - 30))) digest.Append(line).Append('\n');
        return Encoding.GetEncoding(28591).GetBytes(digest.ToString());
    }

    private static string Text(byte[] bytes) => Encoding.GetEncoding(28591).GetString(bytes);
}
