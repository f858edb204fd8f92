using System.Collections.Generic;
using System.Linq;
using System.Threading.Tasks;
using Caterpillar.Geometry;
using Caterpillar.Machines;
using Caterpillar.Toolpaths;

namespace Caterpillar.Slicing;

/// <summary>The supports of a print: found once the regions of all layers are known, and printed with the layers beside them.</summary>
internal static class PrintSupports
{
    /// <summary>Adds supports to finished layers, in place.</summary>
    /// <param name="layers">The finished layers, also those without steps.</param>
    /// <param name="works">The same layers as they were sliced.</param>
    /// <param name="bodies">What is printed.</param>
    /// <param name="helpers">Bodies in which supports are blocked or enforced.</param>
    /// <param name="common">The settings of the print.</param>
    /// <param name="options">Threads, and cancelling.</param>
    public static void Add(
        List<SlicedLayer> layers, LayerWork[] works, IReadOnlyList<Body> bodies, IReadOnlyList<SliceModel> helpers, PrintSettings common,
            ParallelOptions options)
    {
        var stacks = SupportStack.Of(bodies, common);
        if (stacks.Count == 0) return;
        TriMesh[] Used(ModelUse use) => helpers.Where(h => h.Settings.ModelUse == use).Select(h => h.Mesh.Mesh).ToArray();
        var (blockers, enforcers) = (Used(ModelUse.SupportBlocker), Used(ModelUse.SupportEnforcer));
        var places = new Dictionary<LayerWork, int>();
        for (var i = 0; i < works.Length; i++) places.Add(works[i], i);
        foreach (var stack in stacks)
        {
            // Bodies that stand in this stack need no second look: its levels hold them.
            var others = works.Where(w => w.Rules.Settings != stack.Settings || common.PrintSequence == PrintSequence.ByObject || stack.Settings.AdaptiveLayers)
                .Where(w => w.Body != stack.Levels[0].Work.Body).ToArray();
            SupportBuilder.Build(stack, others, blockers, enforcers, options);
            var steps = new List<PathStep>[stack.Levels.Length];
            Parallel.For(0, steps.Length, options, () => new LayerTools(), (i, _, tools) =>
            {
                steps[i] = [];
                if (!stack.Levels[i].Support.IsEmpty) SupportFiller.Add(stack.Levels[i], stack.Settings, tools, steps[i]);
                return tools;
            }, _ => { });
            for (var i = 0; i < steps.Length; i++)
            {
                if (steps[i].Count == 0) continue;
                var at = places[stack.Levels[i].Work];
                layers[at] = layers[at] with { Steps = [.. layers[at].Steps, .. steps[i]], Support = stack.Levels[i].Support };
            }
        }
    }
}
