using System.Linq;
using Caterpillar.GH.Components.Design;
using Caterpillar.GH.Tests.Host;
using Caterpillar.Toolpaths;
using Caterpillar.Turtles;
using Grasshopper.Kernel;
using NUnit.Framework;

namespace Caterpillar.GH.Tests.Recorded;

public sealed class TurtlePreviewTests
{
    [Test]
    public void What_is_printed_is_one_call_and_the_triangle_is_drawn_once()
    {
        var steps = TurtleProgram.FromScript(TurtleScript.Compile("forward 10\nleft 90\nforward 10").Value!).Run().Value!.ToSteps();
        var canvas = new Canvas<TurtlePreviewComponent>().Feed("Steps", steps.Cast<object?>().ToArray()).Feed("Position", 0.75).Solve();
        var display = new Rhino.Display.DisplayPipeline();
        var args = new HeadlessPreviewArgs(canvas.Document, display);
        canvas.Component.DrawViewportWires(args);
        canvas.Component.DrawViewportMeshes(args);
        Assert.That(display.Calls.Select(c => c.What), Is.EqualTo(new[] { "lines", "curve", "shaded" }), "What is printed, then the triangle once.");
        var shade = display.Calls[2].Material;
        canvas.Component.DrawViewportMeshes(args);
        Assert.That(display.Calls[3].Material, Is.SameAs(shade), "A material is made once.");
    }
}
