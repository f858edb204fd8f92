using System;
using System.Collections.Generic;
using System.Globalization;
using System.IO;
using System.Linq;
using Caterpillar.CanvasPictures;
using Caterpillar.GH.Plugin;
using Caterpillar.GH.Tests.Plugin;
using Grasshopper.Kernel;
using Grasshopper.Kernel.Data;
using Grasshopper.Kernel.Special;
using Grasshopper.Kernel.Types;

namespace Caterpillar.GH.Tests.Examples;

/// <summary>What a solved definition shows on the canvas.</summary>
internal static class Shown
{
    private static readonly Lazy<Dictionary<Guid, string>> Names = new(() => PluginTypes.Components
        .ToDictionary(t => PluginTypes.Make<GH_Component>(t).ComponentGuid, Icons.NameOf));

    /// <summary>A picture of a solved definition.</summary>
    public static string Picture(GH_Document document)
        => CanvasPictures.Picture.Svg(Layout.Of(Definition.Read(Sketch.Save(document))), Results(document), Icon);

    /// <summary>A picture of some stages of a solved definition.</summary>
    public static string Picture(GH_Document document, IReadOnlyCollection<string> stages)
        => CanvasPictures.Picture.Svg(Layout.Of(Definition.Read(Sketch.Save(document)).Only(stages)), Results(document), Icon);

    internal static byte[]? Icon(Item item)
    {
        using var stream = Names.Value.TryGetValue(item.Kind, out var name) ? Icons.Open(name) : null;
        if (stream is null) return null;
        using var memory = new MemoryStream();
        stream.CopyTo(memory);
        return memory.ToArray();
    }

    private static Results Results(GH_Document document)
    {
        var panels = document.Objects.OfType<GH_Panel>().Where(p => p.SourceCount > 0).ToDictionary(p => p.InstanceGuid, p => Lines(p.VolatileData));
        var outputs = document.Objects.OfType<IGH_Component>().SelectMany(c => c.Params.Output).Concat(document.Objects.OfType<IGH_Param>());
        var active = document.Objects.OfType<IGH_ActiveObject>().ToArray();
        return new Results(panels, outputs.ToDictionary(o => o.InstanceGuid, o => FlowOf(o.VolatileData)),
            WithLevel(active, GH_RuntimeMessageLevel.Warning), WithLevel(active, GH_RuntimeMessageLevel.Error));
    }

    private static HashSet<Guid> WithLevel(IGH_ActiveObject[] all, GH_RuntimeMessageLevel level)
        => new(all.Where(o => o.RuntimeMessageLevel == level).Select(o => o.InstanceGuid));

    private static Flow FlowOf(IGH_Structure data) => data.PathCount > 1 ? Flow.Tree : data.DataCount > 1 ? Flow.List : Flow.Item;

    private static IReadOnlyList<string> Lines(IGH_Structure data)
        => Enumerable.Range(0, data.PathCount).SelectMany(i => data.get_Branch(i).Cast<object?>())
            .SelectMany(d => Text(d).Replace("\r", "").Split('\n')).ToArray();

    // Grasshopper shows six decimals.
    private static string Text(object? data) => data switch
    {
        null => "<null>",
        GH_Number number => Number(number.Value),
        GH_Point { Value: var p } => $"{{{Number(p.X)}, {Number(p.Y)}, {Number(p.Z)}}}",
        GH_Plane { Value: var p } => $"O{Rounded(p.Origin.X, p.Origin.Y, p.Origin.Z)} Z{Rounded(p.ZAxis.X, p.ZAxis.Y, p.ZAxis.Z)}",
        _ => data.ToString()!,
    };

    private static string Rounded(params double[] values)
        => "(" + string.Join(",", values.Select(v => v.ToString("0.00", CultureInfo.InvariantCulture))) + ")";

    private static string Number(double value) => value.ToString("0.######", CultureInfo.InvariantCulture);
}
