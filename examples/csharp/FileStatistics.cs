using Caterpillar.GCode;
using Caterpillar.Machines;
using Caterpillar.Simulation;

namespace Caterpillar.Examples.CSharp;

/// <summary>What a file prints, and how long that takes by the limits of a printer.</summary>
public static class FileStatistics
{
    public static PrintStatistics Run(string input)
    {
        var setup = new ProfileLibrary().Setup("ender3").OrThrow();
        var file = GCodeDecoder.DecodeFile(input).OrThrow();
        return PrintStatistics.Of(Timeline.Of(file.Toolpath, setup));
    }
}
