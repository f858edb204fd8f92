using Grasshopper.Kernel;

namespace Caterpillar.GH.Base;

/// <summary>The last outputs of each item, given again while its new result is computed.</summary>
internal sealed class LastResults
{
    private readonly Dictionary<int, IReadOnlyList<Action<IGH_DataAccess>>> _items = [];

    public void Keep(int item, IReadOnlyList<Action<IGH_DataAccess>> given) => _items[item] = given;

    public IReadOnlyList<Action<IGH_DataAccess>>? Of(int item) => _items.TryGetValue(item, out var given) ? given : null;

    /// <summary>Forgets the items from a number on.</summary>
    public void Trim(int count)
    {
        foreach (var item in _items.Keys.Where(i => i >= count).ToList()) _items.Remove(item);
    }

    public void Clear() => _items.Clear();
}
