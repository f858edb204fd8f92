using Grasshopper.Kernel;

namespace Caterpillar.GH.Base;

/// <summary>Looks upstream along the wires.</summary>
internal static class Upstream
{
    /// <summary>The name of a component upstream that still computes a new result, so that the data here is old. Null if none.</summary>
    public static string? Pending(IGH_Component component) => Pending(component.Params.Input, []);

    private static string? Pending(IEnumerable<IGH_Param> inputs, HashSet<object> seen)
    {
        foreach (var input in inputs)
        {
            foreach (var source in input.Sources)
            {
                var owner = source.Attributes?.GetTopLevel?.DocObject ?? source;
                if (!seen.Add(owner)) continue;
                var name = owner switch
                {
                    CaterpillarComponent ours => ours.Pending,
                    IGH_Component other => Pending(other.Params.Input, seen),
                    IGH_Param floating => Pending([floating], seen),
                    _ => null,
                };
                if (name is not null) return name;
            }
        }
        return null;
    }
}
