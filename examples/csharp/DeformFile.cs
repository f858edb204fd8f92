using Caterpillar.Jobs;
using Caterpillar.Machines;
using Caterpillar.Shaping;

namespace Caterpillar.Examples.CSharp;

/// <summary>Twists what a file prints by 1° a millimeter about its middle; lengths and E follow.</summary>
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
