using Caterpillar.GCode;
using Caterpillar.Machines;
using Caterpillar.Simulation;

namespace Caterpillar.Examples.CSharp;

/// <summary>Statistics of the print in a file, with the print time on a printer.</summary>
public static class FileStatistics
{
    public static PrintStatistics Run(string input)
    {
        var setup = new ProfileLibrary().Setup("ender3").OrThrow();
        var file = GCodeDecoder.DecodeFile(input).OrThrow();
        return PrintStatistics.Of(Timeline.Of(file.Toolpath, setup));
    }
}
