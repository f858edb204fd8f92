using System;
using System.Linq;
using Caterpillar.Geometry;
using Caterpillar.Jobs;
using Caterpillar.Machines;
using Caterpillar.Toolpaths;

namespace Caterpillar.Examples.CSharp;

/// <summary>Prints a custom path: a wave that also goes up and down.</summary>
public static class CustomPath
{
    public static void Run(string output)
    {
        var setup = new ProfileLibrary().Setup("generic").OrThrow();
        var points = Enumerable.Range(0, 101).Select(i => new Vec3(60 + i, 110 + 15 * Math.Sin(i * 0.2), 0.3 + 0.1 * Math.Sin(i * 0.4)));
        var wave = new PrintPath(points, Bead.FromWidth(width: 0.8, height: 0.3, speed: 15));
        PrintJob.Draw([wave], setup).OrThrow().WriteFile(output).OrThrow();
    }
}
