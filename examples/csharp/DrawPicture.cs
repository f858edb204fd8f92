using Caterpillar.Display;
using Caterpillar.GCode;

namespace Caterpillar.Examples.CSharp;

/// <summary>A picture of what a file prints, seen from above, colored by height.</summary>
public static class DrawPicture
{
    public static void Run(string input, string output)
    {
        var file = GCodeDecoder.DecodeFile(input).OrThrow();
        Picture.WriteFile(file.Toolpath, output, new PictureOptions { View = View.Top, ColorBy = ColorBy.Height });
    }
}
