using Caterpillar.Geometry;
using Caterpillar.Toolpaths;

namespace Caterpillar.GH.Goos;

/// <summary>The beginning of a toolpath.</summary>
internal static class ToolpathPrefix
{
    /// <summary>All moves before one, and that one up to a position, which is a part of it from 0 to 1.</summary>
    public static Toolpath Of(Toolpath toolpath, int move, Vec3 position, double done)
    {
        var builder = new ToolpathBuilder(toolpath.Source, toolpath.Start);
        foreach (var layer in toolpath.Layers) builder.AddLayer(layer);
        var next = 0;
        void AddEvents(int before)
        {
            for (; next < toolpath.Events.Count && toolpath.Events[next].Move <= before; next++) builder.AddEvent(toolpath.Events[next].Event);
        }
        for (var i = 0; i < move && i < toolpath.Count; i++)
        {
            AddEvents(i);
            var m = toolpath[i];
            builder.Add(m.End, m.E, m.Deposited, m.Speed, m.Kind, m.Role, m.Layer, m.Tool, m.Source, m.Arc);
        }
        if (move < toolpath.Count && done > 0)
        {
            AddEvents(move);
            var m = toolpath[move];
            builder.Add(position, m.E * done, m.Deposited * done, m.Speed, m.Kind, m.Role, m.Layer, m.Tool, m.Source,
                m.Arc is { } arc ? arc with { Sweep = arc.Sweep * done } : null);
        }
        return builder.Build(toolpath.Tools);
    }
}
