using System.IO;
using Caterpillar.GCode;
using Caterpillar.Toolpaths;

namespace Caterpillar.Tests;

/// <summary>A toolpath as a new file.</summary>
internal static class NewFile
{
    public static byte[] Of(Toolpath toolpath, GCodeFormat? format = null)
    {
        using var memory = new MemoryStream();
        new GCodeWriter(toolpath, format).WriteAll(memory);
        return memory.ToArray();
    }
}
