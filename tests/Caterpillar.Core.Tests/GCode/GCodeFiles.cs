using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using Caterpillar.GCode;

namespace Caterpillar.Tests.GCode;

/// <summary>The G-code files of the shared data.</summary>
internal static class GCodeFiles
{
    private static readonly string[] None = ["none"];

    /// <summary>Names of all files; one name that does not exist where there is no data, so that the tests are skipped with a message.</summary>
    public static IEnumerable<string> All()
    {
        var folder = Path.GetFullPath(Path.Combine(TestData.Repository, "..", "shared", "data", "gcode"));
        return Directory.Exists(folder)
            ? Directory.GetFiles(folder).Select(f => Path.GetFileName(f)!)
                .Where(f => f.EndsWith(".gcode", StringComparison.Ordinal) || f.EndsWith(".gz", StringComparison.Ordinal))
                .OrderBy(f => f, StringComparer.Ordinal)
            : None;
    }

    /// <summary>All files; under Mono, which is slow, half of those that are not packed, if not all tests run.</summary>
    public static IEnumerable<string> Chosen() => Rounds.Full ? All() : Affordable();

    /// <summary>All files; under Mono, which is slow, half of those that are not packed, or all of these if all tests run.</summary>
    public static IEnumerable<string> Affordable()
        => !Rounds.OnMono ? All() : Rounds.Some(All().Where(f => !f.EndsWith(".gz", StringComparison.Ordinal)), 2);

    /// <summary>The number of a file among all.</summary>
    public static int NumberOf(string file) => Array.IndexOf(All().ToArray(), file);

    public static byte[] Bytes(string file) => TestData.ReadBytes(TestData.Shared("gcode/" + file));

    public static GCodeDocument Document(string file) => GCodeDocument.FromBytes(Bytes(file), file);
}
