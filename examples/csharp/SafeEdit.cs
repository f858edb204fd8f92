using System.Collections.Generic;
using Caterpillar.Basics;
using Caterpillar.Geometry;
using Caterpillar.Jobs;
using Caterpillar.Machines;

namespace Caterpillar.Examples.CSharp;

/// <summary>Moves a print. If it would leave the bed, nothing is written, and the diagnostics state the reason.</summary>
public static class SafeEdit
{
    public static IReadOnlyList<Diagnostic> Run(string input, string output)
    {
        var setup = new ProfileLibrary().Setup("ender3").OrThrow();
        var moved = FileJob.Open(input).OrThrow().Edit(new FileEdits { Move = new Vec3(150, 0) }).OrThrow();
        return moved.WriteFile(output, setup).Diagnostics;
    }
}
