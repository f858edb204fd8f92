using Caterpillar.Checks;
using Caterpillar.GCode;
using Caterpillar.Machines;
using Caterpillar.Toolpaths;

namespace Caterpillar.Examples.CSharp;

/// <summary>Decodes a file, slows its outer walls, adds a pause, and writes it again: all other lines keep their bytes.</summary>
public static class EditFile
{
    public static void Run(string input, string output)
    {
        var file = GCodeDecoder.DecodeFile(input).OrThrow();
        var slower = file.Toolpath.ScaleSpeed(new MoveFilter { Roles = [Role.OuterWall] }, 0.5);
        var edited = slower.InsertAtLayer(12, new PauseEvent("Insert the magnet.")).OrThrow();
        SafeWriter.WriteFile(file, edited, new PrintSetup(), output).OrThrow();
    }
}
