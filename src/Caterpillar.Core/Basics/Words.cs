using System.Linq;

namespace Caterpillar.Basics;

/// <summary>Names of the code as readers see them.</summary>
public static class Words
{
    /// <summary>A name in words: <c>OuterWall</c> is "Outer wall".</summary>
    public static string Spaced(string name)
        => string.Concat(name.Select((c, i) => i > 0 && char.IsUpper(c) ? " " + char.ToLowerInvariant(c) : c.ToString()));
}
