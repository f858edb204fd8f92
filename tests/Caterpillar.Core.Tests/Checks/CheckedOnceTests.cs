using System.Linq;
using Caterpillar.Checks;
using Caterpillar.Geometry;
using Caterpillar.Machines;
using Caterpillar.Planning;
using Caterpillar.Toolpaths;
using NUnit.Framework;

namespace Caterpillar.Tests.Checks;

/// <summary>What was checked before is not checked again while it is written.</summary>
internal sealed class CheckedOnceTests
{
    // A path that runs into what it has printed.
    private static Toolpath Colliding(PrintSetup setup)
    {
        var bead = new Bead(0.08, 0.2, 40);
        Step[] steps =
        [
            new PrintPath(Enumerable.Range(0, 40).Select(i => new Vec3(100 + 10 * (i % 2), 100, 0.2 + 0.2 * i)), bead),
            new PrintPath([new Vec3(80, 100, 0.2), new Vec3(120, 100, 0.2)], bead),
        ];
        return Planner.Plan(steps, setup).Value!;
    }

    [Test]
    public void Collisions_of_a_checked_toolpath_are_not_looked_for_and_the_bytes_are_the_same()
    {
        var setup = new PrintSetup();
        var toolpath = Colliding(setup);
        Assert.That(PrintCheck.Run(toolpath, setup).Select(d => d.Code), Has.Some.EqualTo("collision.nozzle").Or.Some.Contains("collision"));
        Assert.That(SafeWriter.ToDocument(toolpath, setup).Value, Is.Null, "Refused.");
        Assert.That(SafeWriter.ToDocument(toolpath, setup, isChecked: true).Value, Is.Not.Null, "Whoever checked it answers for it.");
        var fine = Planner.Plan([new PrintPath([new Vec3(80, 100, 0.2), new Vec3(120, 100, 0.2)], new Bead(0.08, 0.2, 40))], setup).Value!;
        Assert.That(SafeWriter.ToDocument(fine, setup, isChecked: true).Value!.ToBytes(), Is.EqualTo(SafeWriter.ToDocument(fine, setup).Value!.ToBytes()));
    }

    [Test]
    public void With_start_code_that_prints_all_is_checked()
    {
        var setup = new PrintSetup();
        setup = setup with { Printer = setup.Printer with { StartGCode = new ValueList<string>("G28", "G1 X10 Y10 Z0.3 F3000", "G1 X60 Y10 E2 F1200") } };
        Assert.That(SafeWriter.ToDocument(Colliding(setup), setup, isChecked: true).Value, Is.Null);
    }
}
