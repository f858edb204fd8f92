namespace Caterpillar.Cli;

/// <summary>Checks before any work begins that extensions of inputs and outputs fit the verb, that outputs can be written, and that none is an input.</summary>
internal static class FileGuard
{
    // Options whose values are input files. All arguments are.
    private static readonly string[] Inputs = ["--printer", "--material", "--settings", "--import", "--base"];
    private const string Output = "--output";

    // Extensions, what they suggest, and the verb that reads it.
    private static readonly Dictionary<string, (string Kind, string Reader)> Kinds = EmbeddedText.Rows("usage/FileKinds.tsv", typeof(Verb))
        .ToDictionary(r => r[0], r => (r[1], r[2]), StringComparer.OrdinalIgnoreCase);

    /// <exception cref="CliException">An output is an input, or an extension is wrong (wrong usage).</exception>
    public static void Check(Verb verb, ParseResult parsed)
    {
        foreach (var file in Arguments(parsed)) CheckInput(file, verb.Name);
        var inputs = Arguments(parsed).Concat(Inputs.SelectMany(name => Values(parsed, name))).Where(f => f != "-" && File.Exists(f)).ToArray();
        if (verb.ReplacesInput(parsed)) return;
        foreach (var output in Outputs(parsed))
        {
            CheckName(output, verb.Writes);
            if (inputs.FirstOrDefault(input => IsSame(input, output)) is { } input)
                throw CliException.Usage($"{Output} {output} would replace the input {input}. Give another name.");
        }
    }

    /// <summary>Checks that the folders of outputs exist. A batch makes its own.</summary>
    /// <exception cref="CliException">An output is a folder, or its folder does not exist.</exception>
    public static void CheckFolders(ParseResult parsed)
    {
        foreach (var output in Outputs(parsed))
        {
            if (Directory.Exists(output) && !Values(parsed, "--import").Any()) throw new CliException(ExitCode.BadInput, $"{output} is a folder, not a file.");
            if (Path.GetDirectoryName(output) is { Length: > 0 } folder && !Directory.Exists(folder))
                throw new CliException(ExitCode.BadInput, $"{output}: folder not found.");
        }
    }

    // Designs; verbs for G-code recognize it by its contents.
    private static void CheckInput(string file, string verb)
    {
        if (!Kinds.Values.Any(k => k.Reader == verb && k.Kind != "G-code") || !Kinds.TryGetValue(Path.GetExtension(file), out var named)) return;
        if (named.Reader is "" || named.Reader == verb) return;
        throw CliException.Usage($"{file} is {named.Kind}. To print it, use \"caterpillar {named.Reader}\".");
    }

    private static void CheckName(string output, string[] kinds)
    {
        if (kinds.Length == 0 || !Kinds.TryGetValue(Path.GetExtension(output), out var named) || kinds.Contains(named.Kind)) return;
        throw CliException.Usage(
            $"{Output} {output}: the extension {Path.GetExtension(output)} means {named.Kind}, but the output is {kinds[0]}. Give another name.");
    }

    private static IEnumerable<string> Arguments(ParseResult parsed)
        => parsed.CommandResult.Children.OfType<ArgumentResult>().SelectMany(a => a.Tokens).Select(t => t.Value);

    private static IEnumerable<string> Outputs(ParseResult parsed) => Values(parsed, Output).Where(f => f is not "-" and not "");

    private static IEnumerable<string> Values(ParseResult parsed, string option)
        => parsed.CommandResult.Children.OfType<OptionResult>().Where(o => o.Option.Name == option).SelectMany(o => o.Tokens).Select(t => t.Value);

    private static bool IsSame(string a, string b)
        => string.Equals(Real(a), Real(b), OperatingSystem.IsLinux() ? StringComparison.Ordinal : StringComparison.OrdinalIgnoreCase);

    // The path without links in any of its folders.
    private static string Real(string path)
    {
        var full = FileLinks.Target(Path.GetFullPath(path));
        return Path.GetDirectoryName(full) is { } folder ? Path.Combine(Real(folder), Path.GetFileName(full)) : full;
    }
}
