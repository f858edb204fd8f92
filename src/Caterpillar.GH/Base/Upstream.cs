namespace Caterpillar.GH.Base;

/// <summary>Which inputs of a component wait for results from upstream along the wires, during one solve.</summary>
internal sealed class Upstream(IGH_Component component)
{
    private readonly Dictionary<int, string?> _known = [];

    /// <summary>Nickname of a component whose result is not there yet and that some input depends on. Null if none.</summary>
    public string? Any => Enumerable.Range(0, component.Params.Input.Count).Select(Of).FirstOrDefault(name => name is not null);

    /// <summary>The same for one input.</summary>
    public string? Of(int input)
    {
        if (!_known.TryGetValue(input, out var name)) _known.Add(input, name = Pending([component.Params.Input[input]], []));
        return name;
    }

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
