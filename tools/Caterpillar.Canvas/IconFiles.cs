using System;
using System.IO;
using System.Linq;

namespace Caterpillar.CanvasPictures;

/// <summary>The icons of the plug-in, found by the name of the component.</summary>
internal static class IconFiles
{
    public static byte[]? Of(Item item)
    {
        var name = "icons/" + string.Concat(item.Name.Where(char.IsLetterOrDigit)) + ".png";
        var assembly = typeof(IconFiles).Assembly;
        var found = assembly.GetManifestResourceNames().FirstOrDefault(n => string.Equals(n, name, StringComparison.OrdinalIgnoreCase));
        using var stream = found is null ? null : assembly.GetManifestResourceStream(found);
        if (stream is null) return null;
        using var memory = new MemoryStream();
        stream.CopyTo(memory);
        return memory.ToArray();
    }
}
