using System.Drawing;
using Rhino;
using Rhino.DocObjects;

namespace Caterpillar.GH.Bake;

/// <summary>The layers of a Rhino document for baked objects, by path. Missing layers are added.</summary>
internal static class BakeLayers
{
    public const string Root = "Caterpillar";

    private const string Separator = "::";

    /// <summary>Index of the layer <c>Caterpillar::object::role</c>.</summary>
    public static int Find(RhinoDoc document, string item, string role, Color color)
    {
        var path = Root;
        var parent = Ensure(document, path, Root, Guid.Empty, Color.Black);
        foreach (var name in new[] { item, role })
        {
            // Rhino does not allow the separator in a name.
            var safe = string.Join(":", name.Split([Separator], StringSplitOptions.None)).Trim();
            if (safe.Length == 0) continue;
            path += Separator + safe;
            parent = Ensure(document, path, safe, document.Layers.FindIndex(parent).Id, color);
        }
        return parent;
    }

    private static int Ensure(RhinoDoc document, string path, string name, Guid parent, Color color)
    {
        var found = document.Layers.FindByFullPath(path, -1);
        return found >= 0 ? found : document.Layers.Add(new Layer { Name = name, ParentLayerId = parent, Color = color });
    }
}
