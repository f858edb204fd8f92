using System.IO;
using System.Text;
using System.Text.RegularExpressions;
using Caterpillar.Flavors;
using Caterpillar.GCode;
using Caterpillar.Machines;
using Caterpillar.Toolpaths;

namespace Caterpillar.Tests;

/// <summary>A toolpath as a new file.</summary>
internal static class NewFile
{
    /// <summary>The usual printer, whose files name objects in comments.</summary>
    public static readonly Printer Machine = new() { ObjectLabels = false };

    public static ExtrusionMode Mode(bool relative) => relative ? ExtrusionMode.Relative : ExtrusionMode.Absolute;

    public static byte[] Of(Toolpath toolpath, GCodeFormat? format = null)
    {
        using var memory = new MemoryStream();
        new GCodeWriter(toolpath, format ?? new GCodeFormat(Machine)).WriteAll(memory);
        return memory.ToArray();
    }

    /// <summary>The same as text, without lines that are only comments.</summary>
    public static string Plain(Toolpath toolpath, GCodeFormat? format = null)
        => Regex.Replace(Encoding.ASCII.GetString(Of(toolpath, format)), "^;.*\n", "", RegexOptions.Multiline);

    /// <summary>The rules of a firmware that knows no arcs, and is else like another.</summary>
    public static FlavorRules WithoutArcs(FlavorRules flavor)
    {
        var words = RuleWords.Of(flavor.Name);
        words["Arcs"] = "no";
        return new FlavorRules(words);
    }
}
