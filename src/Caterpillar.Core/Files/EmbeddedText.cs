namespace Caterpillar.Files;

/// <summary>Text files that are embedded in the library.</summary>
internal static class EmbeddedText
{
    /// <summary>The text of a file.</summary>
    /// <exception cref="InvalidOperationException">The library has no such file.</exception>
    public static string Read(string name)
    {
        using var stream = typeof(EmbeddedText).Assembly.GetManifestResourceStream(name)
            ?? throw new InvalidOperationException($"The resource {name} is missing.");
        using var reader = new StreamReader(stream);
        return reader.ReadToEnd();
    }

    /// <summary>The lines of a file that are not empty.</summary>
    public static string[] Lines(string name) => Read(name).Split(['\r', '\n'], StringSplitOptions.RemoveEmptyEntries);

    /// <summary>The cells of a table with tabs between them; lines that begin with <c>#</c> are comments.</summary>
    public static string[][] Rows(string name) => [.. Lines(name).Where(l => l[0] != '#').Select(l => l.Split('\t'))];
}
