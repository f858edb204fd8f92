using Rhino.DocObjects;

namespace Caterpillar.GH.Bake;

/// <summary>The component that baked objects, stated in their user text. A copy of a component or of a definition owns nothing.</summary>
internal sealed record BakeOwner(Guid Definition, Guid Component)
{
    private const string OwnerKey = "caterpillar.owner";
    private const string ItemKey = "caterpillar.item";

    /// <summary>The objects in a document, by their item.</summary>
    public Dictionary<string, List<Guid>> FindIn(RhinoDoc document)
    {
        var found = new Dictionary<string, List<Guid>>(StringComparer.Ordinal);
        foreach (var item in document.Objects.FindByUserString(OwnerKey, Name, true))
        {
            var key = item.Attributes.GetUserString(ItemKey) ?? "";
            if (!found.TryGetValue(key, out var ids)) found.Add(key, ids = []);
            ids.Add(item.Id);
        }
        return found;
    }

    /// <summary>Makes an object one of an item of this component.</summary>
    public void Write(ObjectAttributes attributes, string item)
    {
        attributes.SetUserString(OwnerKey, Name);
        attributes.SetUserString(ItemKey, item);
    }

    private string Name => Definition + "/" + Component;
}
