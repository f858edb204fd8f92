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
    // Levels that are filled before their layers are taken.
    private const int Block = 32;

    /// <summary>Adds supports to finished layers, in place and from below; gives how many layers from the lowest on have theirs.</summary>
    /// <param name="layers">The finished layers, also those without steps.</param>
    /// <param name="works">The same layers as they were sliced.</param>
    /// <param name="bodies">What is printed.</param>
    /// <param name="helpers">Bodies in which supports are blocked or enforced.</param>
    /// <param name="common">The settings of the print.</param>
    /// <param name="options">Threads, and cancelling.</param>
    public static IEnumerable<int> Add(
        List<SlicedLayer> layers, LayerWork[] works, IReadOnlyList<Body> bodies, IReadOnlyList<SliceModel> helpers, PrintSettings common,
            ParallelOptions options)
    {
        var stacks = SupportStack.Of(bodies, common);
        var wanted = new List<(int Layer, SupportLevel Level, PrintSettings Settings)>();
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
            foreach (var level in stack.Levels)
            {
                if (!level.Support.IsEmpty) wanted.Add((places[level.Work], level, stack.Settings));
            }
        }
        wanted.Sort((a, b) => a.Layer.CompareTo(b.Layer));
        for (var first = 0; first < wanted.Count; first += Block)
        {
            var steps = new List<PathStep>[System.Math.Min(Block, wanted.Count - first)];
            Parallel.For(0, steps.Length, options, () => new LayerTools(), (i, _, tools) =>
            {
                var (_, level, settings) = wanted[first + i];
                SupportFiller.Add(level, settings, tools, steps[i] = []);
                return tools;
            }, _ => { });
            for (var i = 0; i < steps.Length; i++)
            {
                if (steps[i].Count == 0) continue;
                var (at, level, _) = wanted[first + i];
                layers[at] = layers[at] with { Steps = [.. layers[at].Steps, .. steps[i]], Support = level.Support };
            }
            yield return wanted[first + steps.Length - 1].Layer + 1;
        }
        yield return layers.Count;
    }
}
