namespace Caterpillar.GH.Components;

/// <summary>The lines of a text, as a Panel gives it; line ends after the last one are none.</summary>
internal static class TextLines
{
    public static string[] Of(string text) => text.TrimEnd('\r', '\n').Split('\n').Select(line => line.TrimEnd('\r')).ToArray();
}
