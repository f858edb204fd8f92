namespace Caterpillar.Jobs;

/// <summary>The settings of a slicer in a 3MF project.</summary>
internal static class ProjectSettings
{
    private static readonly string[] Names = ["Metadata/Slic3r_PE.config", "Metadata/project_settings.config"];

    /// <summary>The bytes of the settings, or null if the file is no project with settings.</summary>
    public static byte[]? Of(byte[] file)
    {
        if (file.Length < 4 || file[0] != 'P' || file[1] != 'K') return null;
        try
        {
            using var archive = new ZipArchive(new MemoryStream(file, false), ZipArchiveMode.Read);
            if (Names.Select(archive.GetEntry).FirstOrDefault(e => e is not null) is not { } entry) return null;
            if (entry.Length > GzipReader.Limit(entry.CompressedLength)) return null;
            using var stream = entry.Open();
            var bytes = new MemoryStream();
            stream.CopyTo(bytes);
            return bytes.ToArray();
        }
        catch (Exception damaged) when (damaged is InvalidDataException or IOException or NotSupportedException)
        {
            return null;
        }
    }
}
