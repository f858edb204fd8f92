using Rhino.DocObjects;

namespace Caterpillar.GH.Bake;

/// <summary>The layers of a Rhino document for baked objects, by path. Missing layers are added.</summary>
internal static class BakeLayers
{
    public const string Root = "Caterpillar";

    private const string Separator = "::";

    /// <summary>The path <c>Caterpillar::object::role</c>. Rhino does not allow the separator in a name.</summary>
    public static string PathOf(string item, string role) => string.Join(Separator, Root, Safe(item), Safe(role));

    /// <summary>Index of the layer of a path.</summary>
    public static int Find(RhinoDoc document, string path, Color color)
    {
        var found = document.Layers.FindByFullPath(path, -1);
        if (found >= 0) return found;
        var (parent, soFar) = (-1, "");
        var names = path.Split([Separator], StringSplitOptions.None).Select(n => n.Trim()).Where(n => n.Length > 0).ToArray();
        for (var i = 0; i < names.Length; i++)
        {
            soFar += i > 0 ? Separator + names[i] : names[i];
            var above = parent < 0 ? Guid.Empty : document.Layers.FindIndex(parent).Id;
            parent = document.Layers.FindByFullPath(soFar, -1);
            if (parent >= 0) continue;
            var own = i == names.Length - 1 ? color : Color.Black;
            parent = document.Layers.Add(new Rhino.DocObjects.Layer { Name = names[i], ParentLayerId = above, Color = own });
        }
        return Math.Max(parent, 0);
    }

    private static string Safe(string name) => string.Join(":", name.Split([':'], StringSplitOptions.RemoveEmptyEntries));
}
