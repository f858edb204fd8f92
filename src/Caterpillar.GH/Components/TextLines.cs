namespace Caterpillar.GH.Components;

/// <summary>The lines of a text from a Panel, without empty lines at the end.</summary>
internal static class TextLines
{
    public static string[] Of(string text) => text.TrimEnd('\r', '\n').Split('\n').Select(line => line.TrimEnd('\r')).ToArray();
}
