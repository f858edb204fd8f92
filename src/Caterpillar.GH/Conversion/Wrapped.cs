namespace Caterpillar.GH.Conversion;

/// <summary>Unwraps the outputs of script components.</summary>
internal static class Wrapped
{
    public static object? Bare(object? source)
    {
        while (source is GH_ObjectWrapper wrapper) source = wrapper.Value;
        return source;
    }

    /// <summary>The text of a string or of text on a wire. Null for anything else.</summary>
    public static string? Text(object? source) => Bare(source) switch
    {
        string text => text,
        GH_String goo => goo.Value,
        _ => null,
    };

    /// <summary>A number, bare or on a wire. Null for anything else.</summary>
    public static double? Number(object? source) => Bare(source) switch
    {
        double number => number,
        int number => number,
        GH_Number goo => goo.Value,
        GH_Integer goo => goo.Value,
        _ => null,
    };
}
