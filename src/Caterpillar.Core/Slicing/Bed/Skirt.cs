using System;
using System.Collections.Generic;
using System.Linq;
using Caterpillar.Geometry;
using Caterpillar.Machines;
using Caterpillar.Toolpaths;

namespace Caterpillar.Slicing;

/// <summary>Loops around everything on the bed, printed first, so that the flow is steady when the part begins.</summary>
internal static class Skirt
{
    /// <summary>The first layer with the skirt in front of its steps.</summary>
    public static SlicedLayer Around(IReadOnlyList<SlicedLayer> layers, PrintSettings settings)
    {
        var first = layers[0];
        // All objects that stand as low as the first layer, which are those that the skirt goes around together.
        var covered = Region.Union(layers.TakeWhile(l => l.Layer.Z <= first.Layer.Z + 1e-9).Select(l => l.Region));
        var rules = SliceRules.Of(settings, first.Layer.Thickness);
        var steps = new List<PathStep>();
        for (var loop = settings.SkirtLoops - 1; loop >= 0; loop--)
        {
            var line = covered.Offset(settings.SkirtDistance + rules.Width / 2 + loop * rules.Pitch(rules.Width), JoinStyle.Round, arcTolerance: 0.05);
            foreach (var island in line.Islands)
            {
                // The outer contour only: a skirt inside a ring would be in the way of nothing.
                var contour = island.Contours[0];
                var points = Array.ConvertAll(contour.Raw, p => p.WithZ(first.Layer.Z));
                var path = PrintPath.Own(points, [rules.Bead(rules.Width)], closed: true).With(Role.Skirt, first.Layer);
                steps.Add(new PathStep(path, new StepGroup(0, -1, settings.SkirtLoops - loop)));
            }
        }
        steps.AddRange(first.Steps);
        return first with { Steps = steps };
    }
}
