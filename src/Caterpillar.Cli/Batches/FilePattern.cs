using System.IO.Enumeration;

namespace Caterpillar.Cli;

/// <summary>Files by patterns: <c>*</c> and <c>?</c> within a name, <c>**</c> for folders of any depth. Shells may expand the patterns instead.</summary>
internal static class FilePattern
{
    /// <summary>The files, in the order of the patterns and of their names, each once.</summary>
    /// <exception cref="CliException">A pattern matches no file (bad input), or is invalid (wrong usage).</exception>
    public static IReadOnlyList<string> Files(IEnumerable<string> patterns)
    {
        var files = new List<string>();
        var seen = new HashSet<string>(StringComparer.Ordinal);
        foreach (var pattern in patterns)
        {
            foreach (var file in Matches(pattern).Where(f => seen.Add(Path.GetFullPath(f)))) files.Add(file);
        }
        return files;
    }

    private static IReadOnlyList<string> Matches(string pattern)
    {
        if (pattern is "-" or "") throw new CliException(ExitCode.Usage, "--each needs file names or patterns.");
        if (File.Exists(pattern)) return [pattern];
        if (Directory.Exists(pattern)) throw new CliException(ExitCode.BadInput, $"{pattern} is a folder. Give the files in it, such as '{Inside(pattern)}'.");
        var slashed = pattern.Replace('\\', '/');
        if (slashed.IndexOfAny(['*', '?']) < 0) throw new CliException(ExitCode.BadInput, $"{pattern}: file not found.");
        var parts = slashed.Split('/');
        var begin = slashed.StartsWith('/') ? "/" : "";
        var found = Under(begin, parts.Where(p => p.Length > 0).ToArray(), 0).Distinct().OrderBy(f => f, StringComparer.Ordinal).ToArray();
        return found.Length > 0 ? found : throw new CliException(ExitCode.BadInput, $"No file matches {pattern}.");
    }

    private static string Inside(string folder) => folder.TrimEnd('/', '\\') + "/*";

    private static IEnumerable<string> Under(string folder, string[] parts, int at)
    {
        var here = folder.Length == 0 ? "." : folder;
        var part = parts[at];
        var isLast = at == parts.Length - 1;
        if (part == "**")
        {
            if (isLast) part = "*";
            else
            {
                foreach (var file in Under(folder, parts, at + 1)) yield return file;
                foreach (var file in Folders(here).SelectMany(name => Under(Join(folder, name), parts, at))) yield return file;
                yield break;
            }
        }
        if (isLast)
        {
            foreach (var name in Names(Directory.EnumerateFiles, here, part)) yield return Join(folder, name);
        }
        else if (part.IndexOfAny(['*', '?']) < 0)
        {
            if (Directory.Exists(Join(folder, part)))
            {
                foreach (var file in Under(Join(folder, part), parts, at + 1)) yield return file;
            }
        }
        else
        {
            foreach (var file in Names(Directory.EnumerateDirectories, here, part).SelectMany(name => Under(Join(folder, name), parts, at + 1)))
                yield return file;
        }
    }

    // Links to folders are not followed below **: they may lead in circles.
    private static IEnumerable<string> Folders(string folder)
        => Names(Directory.EnumerateDirectories, folder, "*").Where(n => new DirectoryInfo(Path.Combine(folder, n)).LinkTarget is null);

    // Names that start with a dot are hidden, unless the pattern starts with one.
    private static IEnumerable<string> Names(Func<string, IEnumerable<string>> list, string folder, string pattern)
        => (Directory.Exists(folder) ? list(folder) : []).Select(p => Path.GetFileName(p))
            .Where(n => (n[0] != '.' || pattern[0] == '.') && FileSystemName.MatchesSimpleExpression(pattern, n, !OperatingSystem.IsLinux()));

    private static string Join(string folder, string name) => folder.Length == 0 ? name : folder.EndsWith('/') ? folder + name : folder + "/" + name;
}
