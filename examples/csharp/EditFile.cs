using Caterpillar.Jobs;
using Caterpillar.Machines;
using Caterpillar.Toolpaths;

namespace Caterpillar.Examples.CSharp;

/// <summary>Opens a file, slows down its outer walls, adds a pause, and writes it. All other lines stay unchanged.</summary>
public static class EditFile
{
    public static void Run(string input, string output)
    {
        var file = FileJob.Open(input).OrThrow();
        var edits = new FileEdits { Filter = new MoveFilter { Roles = [Role.OuterWall] }, Speed = 0.5, PauseAtLayers = [12] };
        file.Edit(edits).OrThrow().WriteFile(output, new PrintSetup()).OrThrow();
    }
}
