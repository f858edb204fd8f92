using System;
using System.IO;
using System.IO.Compression;
using System.Threading;
using Caterpillar.Basics;

namespace Caterpillar.Geometry;

/// <summary>Unpacks gzip, within a bound.</summary>
internal static class GzipBytes
{
    /// <summary>Largest factor by which packed data may grow; meshes grow 3 to 20 times.</summary>
    public const long MaxFactor = 250;

    /// <summary>What may always be unpacked, bytes.</summary>
    public const long MinLimit = 64L << 20;

    public static bool IsPacked(byte[] bytes) => bytes.Length > 2 && bytes[0] == 0x1F && bytes[1] == 0x8B;

    /// <summary>Largest size to which packed data of this length is unpacked, bytes.</summary>
    public static long Limit(long packed) => Math.Min(int.MaxValue - 1024, Math.Max(MinLimit, MaxFactor * packed));

    /// <summary>The unpacked bytes; null with an error where they are damaged or too many.</summary>
    public static byte[]? Unpack(byte[] bytes, string name, DiagnosticList diagnostics, CancellationToken cancel)
    {
        var limit = Limit(bytes.Length);
        using var memory = new MemoryStream();
        try
        {
            using var stream = new GZipStream(new MemoryStream(bytes, false), CompressionMode.Decompress);
            var block = new byte[1 << 16];
            for (int read; (read = stream.Read(block, 0, block.Length)) > 0;)
            {
                cancel.ThrowIfCancellationRequested();
                if (memory.Length + read > limit)
                {
                    diagnostics.Add(Severity.Error, "mesh.packed", $"The file unpacks to more than {NumberFormatter.Format(limit)} bytes.", new SourceLocation(name));
                    return null;
                }
                memory.Write(block, 0, read);
            }
        }
        catch (Exception e) when (e is not OperationCanceledException and not OutOfMemoryException)
        {
            // The runtimes throw different kinds on damaged data.
            diagnostics.Add(Severity.Error, "mesh.packed", "The gzip data is damaged or incomplete.", new SourceLocation(name));
            return null;
        }
        // .NET does not mind a missing end; the last four bytes are the length, modulo 2^32.
        if (bytes.Length < 18 || BitConverter.ToUInt32(bytes, bytes.Length - 4) != (uint)memory.Length)
        {
            diagnostics.Add(Severity.Warning, "mesh.packed", "The gzip data has no good end; it may be incomplete.", new SourceLocation(name));
        }
        return memory.ToArray();
    }
}
