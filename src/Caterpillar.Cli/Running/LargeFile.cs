namespace Caterpillar.Cli;

/// <summary>Reads large files in parallel pieces: most of the time goes into copying them from system memory.</summary>
internal static class LargeFile
{
    private const int PieceSize = 4 << 20;

    /// <summary>All bytes of a regular file.</summary>
    /// <exception cref="IOException">It cannot be read, or has more than 2 GB.</exception>
    public static byte[] ReadAllBytes(string path)
    {
        using var file = File.OpenHandle(path, options: FileOptions.SequentialScan);
        var length = RandomAccess.GetLength(file);
        if (length < 2 * PieceSize || length > Array.MaxLength) return File.ReadAllBytes(path);
        var bytes = GC.AllocateUninitializedArray<byte>((int)length);
        var isShort = false;
        Parallel.For(0, (int)((length + PieceSize - 1) / PieceSize), piece =>
        {
            var rest = bytes.AsSpan(piece * PieceSize, (int)Math.Min(PieceSize, length - (long)piece * PieceSize));
            for (var at = (long)piece * PieceSize; rest.Length > 0;)
            {
                var count = RandomAccess.Read(file, rest, at);
                if (count == 0) isShort = true;
                if (count == 0) break;
                at += count;
                rest = rest[count..];
            }
        });
        // It became shorter meanwhile.
        return isShort ? File.ReadAllBytes(path) : bytes;
    }
}
