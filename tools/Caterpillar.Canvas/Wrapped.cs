using System.Collections.Generic;

namespace Caterpillar.CanvasPictures;

/// <summary>Breaks texts into lines, between words where it can.</summary>
internal static class Wrapped
{
    public static IEnumerable<string> Lines(string text, int letters)
    {
        var rest = text;
        while (rest.Length > letters)
        {
            var at = rest.LastIndexOf(' ', letters);
            if (at <= 0)
            {
                yield return rest.Substring(0, letters);
                rest = rest.Substring(letters);
                continue;
            }
            yield return rest.Substring(0, at);
            rest = rest.Substring(at + 1);
        }
        yield return rest;
    }
}
