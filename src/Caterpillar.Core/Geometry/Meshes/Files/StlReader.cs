namespace Caterpillar.Geometry;

/// <summary>Reads binary STL. The header may begin with anything, also with "solid"; normals and attribute bytes are not used.</summary>
internal static class StlReader
{
    private const int HeaderBytes = 84;
    private const int FacetBytes = 50;

    /// <summary>True if the length matches the count in the header exactly.</summary>
    public static bool HasBinaryLength(byte[] bytes)
        => bytes.Length >= HeaderBytes && HeaderBytes + FacetBytes * (long)BitConverter.ToUInt32(bytes, 80) == bytes.Length;

    public static bool Read(MeshSource source, List<NamedMesh> meshes)
    {
        if (!HasBinaryLength(source.Bytes) && StlTextReader.LooksLikeText(source.Bytes)) return StlTextReader.Read(source, meshes);
        if (source.Length < HeaderBytes)
            return source.ErrorInBinary("mesh.truncated", "The file ends inside the 84 bytes of the STL header.", source.Length);
        long declared = BitConverter.ToUInt32(source.Bytes, 80);
        var there = (source.Length - HeaderBytes) / FacetBytes;
        if (declared == 0 && there > 0 && (source.Length - HeaderBytes) % FacetBytes == 0)
        {
            source.Note(Severity.Warning, "mesh.facet_count", "The STL header states 0 facets. They are counted from the file size.");
            declared = there;
        }
        if (declared > there)
            return source.ErrorInBinary("mesh.truncated",
                $"The STL header states {NumberFormatter.Format(declared)} facets, but the file ends after {NumberFormatter.Format(there)}.", source.Length);
        if (HeaderBytes + FacetBytes * declared < source.Length)
        {
            var trailing = (int)(source.Length - HeaderBytes - FacetBytes * declared);
            source.Note(Severity.Note, "mesh.trailing_bytes", "Bytes after the last facet are ignored.", count: trailing);
        }
        ReadFacets(source, (int)declared, meshes);
        return true;
    }

    private static void ReadFacets(MeshSource source, int count, List<NamedMesh> meshes)
    {
        source.Afford(count);
        var (points, numbers) = new StlCorners(source, HeaderBytes + 12, FacetBytes, count).Weld();
        var builder = new MeshBuilder(points, numbers);
        for (var i = 0; i < numbers.Length; i += 3) builder.AddTriangle(numbers[i], numbers[i + 1], numbers[i + 2]);
        meshes.Add(new NamedMesh(MeshReader.PlainName(source.Name), builder.ToMesh(source.Name, true, source.Diagnostics)));
    }
}
