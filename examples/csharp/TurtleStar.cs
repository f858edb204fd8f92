using Caterpillar.Jobs;
using Caterpillar.Machines;
using Caterpillar.Turtles;

namespace Caterpillar.Examples.CSharp;

/// <summary>Draws a star of ten layers with a turtle.</summary>
public static class TurtleStar
{
    public static void Run(string output)
    {
        var setup = new ProfileLibrary().Setup("generic").OrThrow();
        var turtle = new Turtle().StartAt(90, 120, 0.2).SetBead(width: 0.6, height: 0.2).SetSpeed(20)
            .Repeat(10, layer => layer.Repeat(5, side => side.Forward(40).Right(144)).LiftWorld(0.2));
        PrintJob.Draw(turtle.ToSteps(), setup).OrThrow().WriteFile(output).OrThrow();
    }
}
