namespace Caterpillar.Machines;

/// <summary>Embedded tables of names in other programs: rows of cells, the first row has the titles.</summary>
internal static class NameTable
{
    /// <summary>All rows of a table without its titles.</summary>
    public static IEnumerable<string[]> Rows(string table) => All(table).Skip(1);

    /// <summary>All rows with the titles.</summary>
    public static string[][] All(string table)
    {
        using var stream = typeof(NameTable).Assembly.GetManifestResourceStream($"names/{table}.tsv")!;
        using var reader = new StreamReader(stream);
        return [.. reader.ReadToEnd().Split(['\r', '\n'], StringSplitOptions.RemoveEmptyEntries).Select(l => l.Split('\t'))];
    }
}
