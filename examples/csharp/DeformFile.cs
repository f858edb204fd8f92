using Caterpillar.Jobs;
using Caterpillar.Machines;
using Caterpillar.Shaping;

namespace Caterpillar.Examples.CSharp;

/// <summary>Twists the print in a file by 1° per mm of height about its center. Lengths and E are updated.</summary>
public static class DeformFile
{
    public static void Run(string input, string output)
    {
        var file = FileJob.Open(input).OrThrow();
        var twist = new FileEdits
        {
            Deform = middle => DeformationText.Compile("r, theta + z, z", system: DeformationSystem.Cylindrical, axis: middle).OrThrow(),
        };
        file.Edit(twist).OrThrow().WriteFile(output, new PrintSetup()).OrThrow();
    }
}
