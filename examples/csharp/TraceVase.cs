using System;
using Caterpillar.Geometry;
using Caterpillar.Jobs;
using Caterpillar.Machines;
using Caterpillar.Shaping;
using Caterpillar.Toolpaths;
using Caterpillar.Traces;

namespace Caterpillar.Examples.CSharp;

/// <summary>Prints a vase of one extrusion: a trace of a base and a cylinder without layers, bulged by a deformation.</summary>
public static class TraceVase
{
    public static void Run(string output)
    {
        var setup = new ProfileLibrary().Setup("generic").OrThrow();
        var foot = new Vec3(110, 110, 0.2);
        var cup = new Trace(area: 0.6 * 0.2).SetSpeed(30).Spiral(foot, radius: 24, pitch: 0.6)
            .Helix(foot, radius: 24, height: 60, pitch: 0.2, ramp: new FlowRamp());
        var bulge = Deformation.Cylindrical(p => p with { X = p.X * (1 + 0.25 * Math.Sin(p.Z / 60 * Math.PI)) }, axis: foot);
        PrintJob.Draw(bulge.Apply(cup.ToPaths()).OrThrow().ToSteps(), setup).OrThrow().WriteFile(output).OrThrow();
    }
}
