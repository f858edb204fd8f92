namespace Caterpillar.Files;

/// <summary>Text files that are embedded in the library, or in the assembly of a type.</summary>
internal static class EmbeddedText
{
    /// <summary>The text of a file.</summary>
    /// <exception cref="InvalidOperationException">The library has no such file.</exception>
    public static string Read(string name, Type? of = null)
    {
        using var stream = (of ?? typeof(EmbeddedText)).Assembly.GetManifestResourceStream(name)
            ?? throw new InvalidOperationException($"The resource {name} is missing.");
        using var reader = new StreamReader(stream);
        return reader.ReadToEnd();
    }

    /// <summary>The lines of a file that are not empty.</summary>
    public static string[] Lines(string name, Type? of = null) => Read(name, of).Split(['\r', '\n'], StringSplitOptions.RemoveEmptyEntries);

    /// <summary>The cells of a table with tabs between them; lines that begin with <c>#</c> are comments.</summary>
    public static string[][] Rows(string name, Type? of = null) => [.. Lines(name, of).Where(l => l[0] != '#').Select(l => l.Split('\t'))];
}
