using System.IO.Enumeration;

namespace Caterpillar.Cli;

/// <summary>Files by patterns: <c>*</c> and <c>?</c> within a name, <c>**</c> for folders of any depth. Shells may expand the patterns instead.</summary>
internal static class FilePattern
{
    /// <summary>The files, in the order of the patterns and of their names, each once.</summary>
    /// <exception cref="CliException">A pattern matches no file (bad input), or is invalid (wrong usage).</exception>
    public static IReadOnlyList<string> Files(IEnumerable<string> patterns) => [.. patterns.SelectMany(Matches).DistinctBy(Path.GetFullPath)];

    private static IReadOnlyList<string> Matches(string pattern)
    {
        if (pattern is "-" or "") throw CliException.Usage("--each needs file names or patterns.");
        if (File.Exists(pattern)) return [pattern];
        if (Directory.Exists(pattern))
            throw new CliException(ExitCode.BadInput, $"{pattern} is a folder. Give the files in it, such as '{pattern.TrimEnd('/', '\\')}/*'.");
        var slashed = pattern.Replace('\\', '/');
        var parts = slashed.Split('/');
        var at = Array.FindIndex(parts, p => p.IndexOfAny(['*', '?']) >= 0);
        if (at < 0) throw new CliException(ExitCode.BadInput, $"{pattern}: file not found.");
        var found = Under(string.Concat(parts[..at].Select(p => p + "/")), parts, at).Order(StringComparer.Ordinal).ToArray();
        return found.Length > 0 ? found : throw new CliException(ExitCode.BadInput, $"No file matches {pattern}.");
    }

    private static IEnumerable<string> Under(string folder, string[] parts, int at)
    {
        var root = folder.Length == 0 ? "." : folder;
        if (!Directory.Exists(root)) return [];
        var wild = parts[at..].Where(p => p.Length > 0).ToArray();
        var names = new Regex("^" + string.Concat(wild[..^1].Select(p => p == "**" ? @"((?!\.)[^/]+/)*" : Name(p) + "/")) + Name(wild[^1]) + "$",
            OperatingSystem.IsLinux() ? RegexOptions.None : RegexOptions.IgnoreCase);
        var depth = wild[..^1].Contains("**") ? int.MaxValue : wild.Length - 1;
        return new FileSystemEnumerable<string>(root, (ref FileSystemEntry e) => Path.GetRelativePath(root, e.ToFullPath()).Replace('\\', '/'),
            new EnumerationOptions { RecurseSubdirectories = true, MaxRecursionDepth = depth, AttributesToSkip = 0, IgnoreInaccessible = false })
        {
            ShouldIncludePredicate = (ref FileSystemEntry e) => !e.IsDirectory,
            // Links to folders may lead in circles.
            ShouldRecursePredicate = (ref FileSystemEntry e) => (e.Attributes & FileAttributes.ReparsePoint) == 0,
        }.Where(name => names.IsMatch(name)).Select(name => folder + name);
    }

    // Names that start with a dot are hidden, unless the pattern starts with one.
    private static string Name(string part)
        => (part[0] == '.' ? "" : @"(?!\.)") + Regex.Escape(part).Replace(@"\*", "[^/]*").Replace(@"\?", "[^/]");
}
