using Caterpillar.Jobs;
using Caterpillar.Machines;
using Caterpillar.Toolpaths;

namespace Caterpillar.Examples.CSharp;

/// <summary>Decodes a file, slows its outer walls, adds a pause, and writes it again: all other lines keep their bytes.</summary>
public static class EditFile
{
    public static void Run(string input, string output)
    {
        var file = FileJob.Open(input).OrThrow();
        var edits = new FileEdits { Filter = new MoveFilter { Roles = [Role.OuterWall] }, Speed = 0.5, PauseAtLayers = [12] };
        file.Edit(edits).OrThrow().WriteFile(output, new PrintSetup()).OrThrow();
    }
}
