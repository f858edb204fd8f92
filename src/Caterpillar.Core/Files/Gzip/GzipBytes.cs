namespace Caterpillar.Files;

/// <summary>Unpacks gzip in memory.</summary>
internal static class GzipBytes
{
    /// <summary>The bytes, decompressed if necessary. Null with an error if they are damaged, cut off or too many.</summary>
    /// <param name="bytes">The file.</param>
    /// <param name="name">Name for messages.</param>
    /// <param name="code">Code of the diagnostics.</param>
    /// <param name="diagnostics">Receives the diagnostics.</param>
    /// <param name="memory">Memory limit.</param>
    /// <param name="cancel">Cancels the work.</param>
    public static byte[]? Unpack(byte[] bytes, string name, string code, DiagnosticList diagnostics, MemoryLimit memory, CancellationToken cancel)
    {
        if (!GzipReader.IsPacked(bytes, bytes.Length)) return bytes;
        using var plain = new MemoryStream();
        using var stream = new GzipReader(new MemoryStream(bytes, false));
        try
        {
            var block = new byte[1 << 16];
            for (int read; (read = stream.Read(block, 0, block.Length)) > 0;)
            {
                cancel.ThrowIfCancellationRequested();
                if (plain.Length + read > int.MaxValue - 1024) throw new InvalidDataException("It decompresses to more than 2 GB.");
                // Growing doubles the buffer, and the result is a copy.
                if (plain.Length + read > plain.Capacity
                    && memory.Refuse(4.0 * plain.Capacity, "The unpacked file", new SourceLocation(name)) is { } tooMuch)
                {
                    diagnostics.Add(tooMuch);
                    return null;
                }
                plain.Write(block, 0, read);
            }
        }
        catch (InvalidDataException broken)
        {
            diagnostics.Add(Severity.Error, code, "The gzip file cannot be decompressed. " + broken.Message, new SourceLocation(name));
            return null;
        }
        if (stream.HasTrailingBytes) diagnostics.Add(GzipReader.TrailingBytes(code, name));
        return plain.ToArray();
    }
}
