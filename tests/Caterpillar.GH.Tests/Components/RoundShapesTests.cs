using System;
using System.Linq;
using Caterpillar.Geometry;
using Caterpillar.GH.Components.Path;
using Caterpillar.GH.Components.Simulate;
using Caterpillar.GH.Conversion;
using Caterpillar.GH.Goos;
using Caterpillar.GH.Preview;
using Caterpillar.GH.Tests.Host;
using Caterpillar.Machines;
using Caterpillar.Planning;
using Caterpillar.Toolpaths;
using NUnit.Framework;

namespace Caterpillar.GH.Tests.Components;

/// <summary>Arcs, round beds and the boxes of a head as they are shown.</summary>
[Category("Host")]
public sealed class RoundShapesTests
{
    private static readonly Printer Round = new() { BedShape = BedShape.Round, BuildVolume = new Vec3(200, 200, 300) };

    private static ToolpathGoo HalfCircle()
    {
        var arc = new Rg.ArcCurve(new Rg.Arc(new Rg.Plane(new Rg.Point3d(110, 110, 0.2), Rg.Vector3d.XAxis, Rg.Vector3d.YAxis), 10, Math.PI));
        var path = new Canvas<ConstructPrintPathComponent>().Feed("Curve", arc).Feed("Keep Arc", true).Solve().One<PrintPath>("Print Path");
        Assert.That(path.ArcOf(0), Is.Not.Null);
        var setup = new PrintSetup();
        return new ToolpathGoo(Planner.Plan([path], setup, new PlanOptions { Policy = PlanPolicy.AsDrawn }).Value!, setup);
    }

    [Test]
    public void The_move_in_progress_of_an_arc_is_that_part_of_it()
    {
        var canvas = new Canvas<SimulateComponent>().Feed("Toolpath", HalfCircle()).Feed("Position Unit", "Length").Feed("Position", 0.97).Solve();
        Assert.That(canvas.Errors, Is.Empty);
        var current = canvas.One<Rg.Curve>("Current");
        Assert.That(current.PointAtStart.DistanceTo(new Rg.Point3d(120, 110, 0.2)), Is.LessThan(1e-9));
        Assert.That(current.GetLength(), Is.InRange(5, Math.PI * 10 - 1));
        var angle = current.GetLength() / 10;
        Assert.That(current.PointAtEnd.DistanceTo(new Rg.Point3d(110 + 10 * Math.Cos(angle), 110 + 10 * Math.Sin(angle), 0.2)), Is.LessThan(0.05));
        Assert.That(current.PointAtEnd.DistanceTo(canvas.One<Rg.Plane>("Plane").Origin), Is.LessThan(1e-9));
    }

    [Test]
    public void The_wire_of_an_arc_is_round()
    {
        var lines = new System.Collections.Generic.List<Rg.Line>();
        ((Caterpillar.GH.Preview.IWires)HalfCircle()).AddTo(lines, DocumentUnits.Current, default, 0);
        Assert.That(lines.Sum(l => l.Length), Is.EqualTo(Math.PI * 10).Within(0.05));
        Assert.That(lines.Skip(1).Select((l, i) => l.From.DistanceTo(lines[i].To)), Has.All.LessThan(1e-9));
    }

    [Test]
    public void A_round_bed_is_a_circle_and_its_volume_a_cylinder()
    {
        var bed = RhinoGeometry.ToBed(Round, DocumentUnits.Current);
        Assert.That(bed.GetLength(), Is.EqualTo(Math.PI * 200).Within(1e-3));
        var lines = VolumeOutline.Of(Round, DocumentUnits.Current);
        var center = Round.BuildBounds.Center;
        Assert.That(lines.SelectMany(l => new[] { l.From, l.To }).Select(p => new Vec3(p.X, p.Y).DistanceTo(center.WithZ(0))),
            Has.All.EqualTo(100).Within(1e-6));
        Assert.That(lines.Max(l => l.To.Z), Is.EqualTo(300));
    }

    [Test]
    public void Beads_reach_script_components_and_say_when_there_is_none()
    {
        var goo = new BeadGoo(new Bead(0.08, 0.2, 40));
        var bead = default(Bead);
        Assert.That(goo.CastTo(ref bead), Is.True);
        Assert.That(bead, Is.EqualTo(goo.Value));
        var plane = default(Rg.Plane);
        Assert.That(goo.CastTo(ref plane), Is.False);
        Assert.That((new BeadGoo().IsValidWhyNot, goo.IsValidWhyNot), Is.EqualTo(("No bead.", "")));
    }
}
