using System.Collections.Generic;
using System.Threading;
using Caterpillar.Geometry;

namespace Caterpillar.Slicing;

/// <summary>The trees of a body that hold its skins up from below. They grow downwards, so they need the outlines of all its layers.</summary>
internal static class LightningPlan
{
    public static IReadOnlyList<Polyline>[] Of(Body body, CancellationToken cancel)
    {
        var engine = new RegionEngine();
        var areas = new Region[body.Layers.Length];
        var heights = new double[areas.Length];
        for (var i = 0; i < areas.Length; i++)
        {
            cancel.ThrowIfCancellationRequested();
            var layer = body.Layers[i];
            heights[i] = layer.Plan.Top;
            areas[i] = AreaFiller.CenterLines(ThickInfill.SparseOf(layer, engine), layer.Rules, layer.Rules.Width, engine);
        }
        var tops = new Region[areas.Length];
        for (var i = 0; i < tops.Length; i++) tops[i] = i + 1 < tops.Length ? areas[i].Subtract(areas[i + 1], engine) : areas[i];
        var spacing = body.Layers.Length > 0 ? body.Layers[0].Rules.InfillSpacing : 0;
        return spacing > 0 ? Lightning.Grow(areas, tops, spacing, heights, cancel) : new IReadOnlyList<Polyline>[areas.Length];
    }
}
