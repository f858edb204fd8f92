using System;
using System.IO;
using System.IO.Compression;
using System.Linq;
using Caterpillar.Geometry;
using NUnit.Framework;

namespace Caterpillar.Tests;

/// <summary>Finds the repository and the shared test data (meshes and G-code with known results) beside it.</summary>
internal static class TestData
{
    public static string Repository { get; } = FindRepository();

    /// <summary>A file of the shared test data, for example <c>meshes/torus.obj</c>. The test is skipped if the data is absent.</summary>
    public static string Shared(string path)
    {
        var full = Path.GetFullPath(Path.Combine(Repository, "..", "shared", "data", path.Replace('/', Path.DirectorySeparatorChar)));
        if (!File.Exists(full) && !Directory.Exists(full)) Assert.Ignore($"The shared test data is not here: shared/data/{path}");
        return full;
    }

    /// <summary>The known results of the G-code files as JSON, with our names for six of their keys.</summary>
    public static string GCodeTruth()
    {
        var text = File.ReadAllText(Shared("gcode/truth.json"));
        (string Theirs, string Ours)[] names =
        [
            ("travel_with_retract", "travel_with_retraction"), ("retracts", "retractions"), ("unretracts", "deretractions"),
            ("fw_retracts", "firmware_retractions"), ("fw_unretracts", "firmware_deretractions"), ("noops", "no_ops"),
        ];
        foreach (var (theirs, ours) in names) text = text.Replace($"\"{theirs}\":", $"\"{ours}\":");
        return text;
    }

    /// <summary>The bytes of a file, decompressed if its name ends in .gz.</summary>
    public static byte[] ReadBytes(string file)
    {
        if (!file.EndsWith(".gz", StringComparison.Ordinal)) return File.ReadAllBytes(file);
        using var packed = new GZipStream(File.OpenRead(file), CompressionMode.Decompress);
        using var memory = new MemoryStream();
        packed.CopyTo(memory);
        return memory.ToArray();
    }

    /// <summary>Everything in a mesh file as one mesh.</summary>
    public static TriMesh Mesh(string file) => TriMesh.Merge(MeshReader.Read(file).Value!.Select(m => m.Mesh));

    private static string FindRepository()
    {
        for (var folder = new DirectoryInfo(AppContext.BaseDirectory); folder is not null; folder = folder.Parent)
        {
            if (File.Exists(Path.Combine(folder.FullName, "Caterpillar.sln"))) return folder.FullName;
        }
        throw new DirectoryNotFoundException("Caterpillar.sln is not above " + AppContext.BaseDirectory);
    }
}
