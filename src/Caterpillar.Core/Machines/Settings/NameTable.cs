using System.Reflection;

namespace Caterpillar.Machines;

/// <summary>Embedded tables of names in other programs: rows of cells, the first row has the titles.</summary>
internal static class NameTable
{
    /// <summary>The rows of a table without its titles.</summary>
    /// <param name="table">Its name.</param>
    /// <param name="assembly">The assembly that has it; null = this one.</param>
    public static IEnumerable<string[]> Rows(string table, Assembly? assembly = null) => All(table, assembly).Skip(1);

    /// <summary>All rows with the titles.</summary>
    public static string[][] All(string table, Assembly? assembly = null)
    {
        using var stream = (assembly ?? typeof(NameTable).Assembly).GetManifestResourceStream($"names/{table}.tsv")!;
        using var reader = new StreamReader(stream);
        return [.. reader.ReadToEnd().Split(['\r', '\n'], StringSplitOptions.RemoveEmptyEntries).Select(l => l.Split('\t'))];
    }
}
