using System;
using System.Linq;
using Caterpillar.Basics;
using Caterpillar.Geometry;
using Caterpillar.Machines;
using Caterpillar.Planning;
using Caterpillar.Toolpaths;
using NUnit.Framework;

namespace Caterpillar.Tests.Toolpaths;

/// <summary>Steps and toolpaths as bytes.</summary>
internal sealed class StoredBytesTests
{
    private static readonly PrintPath Path = new(
        [new Vec3(10, 0, 0.2), new Vec3(0, 10, 0.2), new Vec3(0, 20, 0.3)], [new Bead(0.08, 0.2, 40), new Bead(0.1, 0.2)], false,
        [new Arc(Vec3.Zero, 90), null])
    {
        Role = Role.OuterWall, Layer = new Layer(3, 0.2, 0.2, "Väse"), Tool = 1, Name = "one", Color = 0x112233, Overrides = new PathOverrides(Fan: 0.5),
    };

    private static readonly PathStep Full = new(Path, new StepGroup(1, 2, 3))
    {
        KeepStart = true, Joined = true, GoesOn = true, Source = new SourceLocation("a.txt", 4), Lines = [5, 6],
        Region = Region.Rectangle(0, 0, 10, 20),
    };

    private static Toolpath Planned()
    {
        Step[] steps =
        [
            Full with { Path = Path with { Tool = 0 } }, new NozzleTemperatureEvent(210, true),
            new PrintPath([new Vec3(0, 0, 0.4), new Vec3(30, 0, 0.4)], new Bead(0.08, 0.2, 40)), new CommentEvent("x"), new EventStep(new DwellEvent(2)),
        ];
        return Planner.Plan(steps, new PrintSetup()).Value!;
    }

    [Test]
    public void A_path_keeps_everything()
    {
        var bytes = StepBytes.Pack(Full);
        var back = (PathStep)StepBytes.Unpack(bytes)!;
        Assert.That(back.Path.Points, Is.EqualTo(Path.Points));
        Assert.That(Enumerable.Range(0, 2).Select(i => (back.Path.BeadOf(i), back.Path.ArcOf(i))), Is.EqualTo(Enumerable.Range(0, 2)
            .Select(i => (Path.BeadOf(i), Path.ArcOf(i)))));
        Assert.That((back.Path.Role, back.Path.Layer, back.Path.Tool, back.Path.Name, back.Path.Color, back.Path.Overrides),
            Is.EqualTo((Path.Role, Path.Layer, Path.Tool, Path.Name, Path.Color, Path.Overrides)));
        Assert.That((back.Group, back.KeepStart, back.Joined, back.GoesOn, back.Source), Is.EqualTo((Full.Group, true, true, true, Full.Source)));
        Assert.That(back.Lines, Is.EqualTo(Full.Lines));
        Assert.That(back.Region!.Area, Is.EqualTo(200).Within(1e-9));
        Assert.That(StepBytes.Pack(back), Is.EqualTo(bytes), "The same bytes again.");
    }

    [Test]
    public void Travels_and_events_come_back()
    {
        var travel = (TravelStep)StepBytes.Unpack(StepBytes.Pack(new TravelStep([Vec3.Zero, new Vec3(1, 2, 3)], 50, TravelIntent.Return)))!;
        Assert.That(travel.Points, Is.EqualTo(new[] { Vec3.Zero, new Vec3(1, 2, 3) }));
        Assert.That((travel.Speed, travel.Intent), Is.EqualTo((50.0, TravelIntent.Return)));
        PrinterEvent[] events =
        [
            new NozzleTemperatureEvent(200, true, 1), new BedTemperatureEvent(60), new FanEvent(0.25), new ToolEvent(2), new AccelerationEvent(500),
            new HomeEvent(true, false, true), new DwellEvent(0.1), new PauseEvent("ä\n"), new CommentEvent("c"), new RawEvent("M117"),
            new ExtrudeEvent(-1.5, 20, true), new FinishMovesEvent(), new LimitEvent(default, 3), new ProgressEvent(10, 5),
        ];
        foreach (var what in events) Assert.That(((EventStep)StepBytes.Unpack(StepBytes.Pack(what))!).Event, Is.EqualTo(what));
    }

    [Test]
    public void A_toolpath_keeps_everything()
    {
        var toolpath = Planned();
        var bytes = ToolpathBytes.Pack(toolpath);
        var back = ToolpathBytes.Unpack(bytes)!;
        Assert.That(back.Moves().SequenceEqual(toolpath.Moves()), Is.True);
        Assert.That(back.Events, Is.EqualTo(toolpath.Events));
        Assert.That(back.Layers, Is.EqualTo(toolpath.Layers));
        Assert.That(back.Tools, Is.EqualTo(toolpath.Tools));
        Assert.That((back.Start, back.Source), Is.EqualTo((toolpath.Start, toolpath.Source)));
        Assert.That(Enumerable.Range(0, back.Count).Select(back.PlaceOf), Is.EqualTo(Enumerable.Range(0, back.Count).Select(toolpath.PlaceOf)));
        Assert.That(ToolpathBytes.Pack(back), Is.EqualTo(bytes), "The same bytes again.");
    }

    [Test]
    public void Damaged_bytes_give_nothing_and_never_throw()
    {
        var random = new Random(7);
        foreach (var bytes in new[] { ToolpathBytes.Pack(Planned()), StepBytes.Pack(Full) })
        {
            for (var i = 0; i < 300; i++)
            {
                var damaged = (byte[])bytes.Clone();
                if (i % 3 == 0) Array.Resize(ref damaged, random.Next(damaged.Length));
                else damaged[random.Next(damaged.Length)] = (byte)random.Next(256);
                Assert.That(() => ToolpathBytes.Unpack(damaged), Throws.Nothing);
                Assert.That(() => StepBytes.Unpack(damaged), Throws.Nothing);
            }
        }
        Assert.That(ToolpathBytes.Unpack([]), Is.Null);
        Assert.That(ToolpathBytes.Unpack([9, 1, 2]), Is.Null, "Another version.");
    }
}
