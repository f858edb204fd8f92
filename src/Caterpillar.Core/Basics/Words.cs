namespace Caterpillar.Basics;

/// <summary>Converts names of the code into words and keys.</summary>
internal static class Words
{
    /// <summary>A name in words: <c>OuterWall</c> is "Outer wall".</summary>
    public static string Spaced(string name)
        => string.Concat(name.Select((c, i) => i > 0 && char.IsUpper(c) ? " " + char.ToLowerInvariant(c) : c.ToString()));

    /// <summary>Alternatives: "a, b or c".</summary>
    internal static string Either(IReadOnlyList<string> names)
        => names.Count == 1 ? names[0] : string.Join(", ", names.Take(names.Count - 1)) + " or " + names[names.Count - 1];

    /// <summary>A text with another part in place of each occurrence of one, letter by letter.</summary>
    public static string Replaced(string text, string part, string other) => string.Join(other, text.Split([part], StringSplitOptions.None));

    /// <summary>A name in snake case: <c>OuterWall</c> and "Outer wall" are <c>outer_wall</c>.</summary>
    public static string Snake(string name)
        => string.Concat(name.Select((c, i) => c is ' ' or '-' ? "_" : (i > 0 && char.IsUpper(c) ? "_" : "") + char.ToLowerInvariant(c)));
}
