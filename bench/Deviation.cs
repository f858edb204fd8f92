using System;
using System.Globalization;
using System.IO;
using System.Linq;
using Caterpillar.Geometry;
using Caterpillar.Machines;
using Caterpillar.Tests.Slicing;

namespace Caterpillar.Bench;

/// <summary><c>deviation MODEL...</c>: how far the outer walls of all layers lie from where the exact plane sections want them.</summary>
internal static class Deviation
{
    /// <summary>A table in Markdown.</summary>
    public static void Run(string[] files)
    {
        Console.WriteLine("| mesh | outer walls | more than 12.5 µm off | largest |");
        Console.WriteLine("|---|---|---|---|");
        foreach (var file in files)
        {
            var mesh = TriMesh.Merge(MeshReader.Read(file).Value!.Select(m => m.Mesh).ToArray());
            var deviation = ContourDeviation.Of(mesh, new PrintSettings(), 1);
            var (length, share, largest) = (Text(deviation.Length / 1000, "F1"), Text(deviation.SharePercent, "F3"), Text(1000 * deviation.Largest, "F0"));
            Console.WriteLine($"| {Path.GetFileNameWithoutExtension(file)} | {length} m | {share} % | {largest} µm |");
        }
    }

    private static string Text(double value, string format) => value.ToString(format, CultureInfo.InvariantCulture);
}
