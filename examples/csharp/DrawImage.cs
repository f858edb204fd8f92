using Caterpillar.Display;
using Caterpillar.GCode;

namespace Caterpillar.Examples.CSharp;

/// <summary>An image of what a file prints, seen from above, colored by height.</summary>
public static class DrawImage
{
    public static void Run(string input, string output)
    {
        var file = GCodeDecoder.DecodeFile(input).OrThrow();
        ToolpathImage.WriteFile(file.Toolpath, output, new ToolpathImageOptions { View = View.Top, ColorBy = ColorBy.Height });
    }
}
