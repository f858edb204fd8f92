using Caterpillar.Checks;
using Caterpillar.GCode;
using Caterpillar.Machines;
using Caterpillar.Shaping;
using Caterpillar.Toolpaths;

namespace Caterpillar.Examples.CSharp;

/// <summary>Twists what a file prints by 1° a millimeter about its middle; lengths and E follow.</summary>
public static class DeformFile
{
    public static void Run(string input, string output)
    {
        var file = GCodeDecoder.DecodeFile(input).OrThrow();
        var middle = MoveFilter.Prints.InLayersOf(file.Toolpath).BoundsIn(file.Toolpath).Center;
        var twist = DeformationText.Compile("r, theta + z, z", system: DeformationSystem.Cylindrical, axis: middle).OrThrow();
        SafeWriter.WriteFile(file, file.Toolpath.Deform(twist).OrThrow(), new PrintSetup(), output).OrThrow();
    }
}
