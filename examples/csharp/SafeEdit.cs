using System.Collections.Generic;
using Caterpillar.Basics;
using Caterpillar.Checks;
using Caterpillar.GCode;
using Caterpillar.Geometry;
using Caterpillar.Machines;
using Caterpillar.Toolpaths;

namespace Caterpillar.Examples.CSharp;

/// <summary>Moves a print. Where it would leave the bed nothing is written, and the diagnostics say why.</summary>
public static class SafeEdit
{
    public static IReadOnlyList<Diagnostic> Run(string input, string output)
    {
        var setup = new ProfileLibrary().Setup("ender3").OrThrow();
        var file = GCodeDecoder.DecodeFile(input).OrThrow();
        var part = new MoveFilter().InLayersOf(file.Toolpath);
        var moved = file.Toolpath.Transform(part, Affine.Move(new Vec3(150, 0)));
        return SafeWriter.WriteFile(file, moved, setup, output).Diagnostics;
    }
}
