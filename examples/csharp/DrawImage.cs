using Caterpillar.Display;
using Caterpillar.GCode;

namespace Caterpillar.Examples.CSharp;

/// <summary>Draws an image of the print in a file, seen from above and colored by height.</summary>
public static class DrawImage
{
    public static void Run(string input, string output)
    {
        var file = GCodeDecoder.DecodeFile(input).OrThrow();
        ToolpathImage.WriteFile(file.Toolpath, output, new ToolpathImageOptions { View = View.Top, ColorBy = ColorBy.Height });
    }
}
