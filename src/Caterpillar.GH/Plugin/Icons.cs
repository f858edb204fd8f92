namespace Caterpillar.GH.Plugin;

/// <summary>The icons embedded in the plug-in: 24 × 24 PNG, named after their class.</summary>
internal static class Icons
{
    private const string Suffix = "Component";
    private const string Fallback = "Component";

    /// <summary>The icon of a class, the general one if it has none of its own, or null if this platform cannot make bitmaps.</summary>
    public static Bitmap? Load(string name)
    {
        try
        {
            using var stream = Open(name) ?? Open(Fallback);
            if (stream is null) return null;
            // A bitmap reads its stream as long as it lives: it gets one of its own that nobody closes.
            var memory = new MemoryStream();
            stream.CopyTo(memory);
            memory.Position = 0;
            return new Bitmap(memory);
        }
        catch (Exception e) when (e is TypeInitializationException or PlatformNotSupportedException or DllNotFoundException or ArgumentException
            or FileNotFoundException)
        {
            return null;
        }
    }

    /// <summary>Name of the icon of a component or parameter: its class name without the suffix.</summary>
    internal static string NameOf(Type type) => type.Name.EndsWith(Suffix, StringComparison.Ordinal)
        ? type.Name.Substring(0, type.Name.Length - Suffix.Length)
        : type.Name;

    /// <summary>The PNG of a class, or null if it has none of its own.</summary>
    internal static Stream? Open(string name) => typeof(Icons).Assembly.GetManifestResourceStream($"icons/{name}.png");
}
