using System.Collections.Generic;
using System.Linq;
using Grasshopper.Kernel;

namespace Caterpillar.GH.Tests.Host;

/// <summary>What the objects of a definition tell their user.</summary>
internal static class Told
{
    private static readonly GH_RuntimeMessageLevel[] Levels = [GH_RuntimeMessageLevel.Error, GH_RuntimeMessageLevel.Warning, GH_RuntimeMessageLevel.Remark];

    /// <summary>All errors, warnings and remarks, with the name of the object before them.</summary>
    public static string[] Messages(this GH_Document document) => document.Objects.OfType<IGH_ActiveObject>().SelectMany(MessagesOf).ToArray();

    private static IEnumerable<string> MessagesOf(IGH_ActiveObject item)
        => Levels.SelectMany(level => item.RuntimeMessages(level).Select(text => $"{item.Name}, {level}: {text}"));
}
