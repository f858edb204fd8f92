using Caterpillar.Flavors;
using Caterpillar.GCode;
using Caterpillar.Jobs;

namespace Caterpillar.Examples.CSharp;

/// <summary>Converts a file to another firmware, with relative E.</summary>
public static class ConvertFile
{
    public static void Run(string input, string output)
    {
        var file = FileJob.Open(input).OrThrow();
        var klipper = file with { Target = new ConvertOptions { Flavor = FlavorTable.Klipper, RelativeE = true } };
        klipper.WriteFile(output, setup: null).OrThrow();
    }
}
