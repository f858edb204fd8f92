using System;
using System.Collections.Generic;
using System.Linq;
using Caterpillar.Basics;
using Caterpillar.Checks;
using Caterpillar.Geometry;
using Caterpillar.Jobs;
using Caterpillar.Machines;
using Caterpillar.Planning;
using Caterpillar.Simulation;
using Caterpillar.Tests.Slicing;
using Caterpillar.Toolpaths;
using NUnit.Framework;

namespace Caterpillar.Tests.Jobs;

/// <summary>Lines on the side of a cone, printed by a head that leans by 84 degrees.</summary>
[Category("Arithmetic")]
public class SidePrintTests
{
    private static readonly Vec3 Place = new(150, 150, 0);
    private static readonly TriMesh Cone = Solids.Cone(0, 30, 100, 20).Transformed(Affine.Move(Place));
    private static readonly PrintSetup Setup = new ProfileLibrary().Setup("five_axis_head").OrThrow();

    [Test]
    public void Separate_lines_around_an_object_are_printed_from_its_side_without_touching_it()
    {
        using var job = PrintJob.Draw(Lines().ToSteps(), Setup, Options).OrThrow();
        var findings = PrintCheck.Run(job.Toolpath, job.Setup);
        Assert.That(findings.Where(f => f.Severity != Severity.Note), Is.Empty);
        Assert.That(job.Toolpath.Moves().Where(m => m.Kind == MoveKind.Print).Sum(m => m.Length), Is.EqualTo(Lines().Sum(p => p.Length)).Within(1e-6));
    }

    [Test]
    public void Travels_along_the_side_leave_and_come_along_the_tool()
    {
        using var job = PrintJob.Draw(Lines().ToSteps(), Setup, Options).OrThrow();
        var moves = job.Toolpath.Moves().ToArray();
        var lines = 0;
        for (var i = 1; i < moves.Length; i++)
        {
            if (moves[i].Kind != MoveKind.Travel || moves[i - 1].Kind == MoveKind.Travel || moves[i].IsInPlace) continue;
            // The bead before, over what happens in place.
            var bead = i - 1;
            while (bead > 0 && moves[bead].Kind != MoveKind.Print) bead--;
            if (bead == 0) continue;
            var away = moves[i].End - moves[i].Start;
            Assert.That(away.Unit().DistanceTo(Out(moves[i].Start)), Is.LessThan(0.02), $"move {i}");
            lines++;
        }
        Assert.That(lines, Is.GreaterThanOrEqualTo(Lines().Length - 1));
    }

    [Test]
    public void A_line_leans_less_only_where_the_head_would_hit_something()
    {
        // Past a post toward which the head leans.
        var post = TriMesh.Box(new Bounds(new Vec3(170, 148, 0), new Vec3(174, 152, 120)));
        var leans = Leans(post, [new Vec3(150, 90, 20), new Vec3(150, 210, 20)], new ToolAim(_ => new Vec3(Angle.Sin(60), 0, Angle.Cos(60))));
        Assert.That(leans.Where(l => Math.Abs(l.Place.Y - 150) > 35).Select(l => l.Lean), Is.All.EqualTo(60).Within(1e-3));
        Assert.That(leans.Where(l => Math.Abs(l.Place.Y - 150) < 2).Select(l => l.Lean), Is.All.LessThan(31));
    }

    [Test]
    public void A_thin_wall_is_printed_from_one_of_its_sides_if_there_is_no_other_way()
    {
        // A post ahead, and a roof over both.
        var between = TriMesh.Merge([
            TriMesh.Box(new Bounds(new Vec3(170, 149, 0), new Vec3(172, 151, 200))), TriMesh.Box(new Bounds(new Vec3(120, 120, 70), new Vec3(200, 180, 72))),
        ]);
        Vec3[] line = [new(150, 149.5, 50), new(150, 150.5, 50)];
        var aim = new ToolAim(_ => Vec3.UnitX);
        Assert.That(Leans(between, line, aim).Select(l => l.Tool.Y), Is.All.EqualTo(0).Within(1e-9), "Nothing else is known.");
        Assert.That(Leans(between, line, aim with { Side = _ => Vec3.UnitY }).Select(l => l.Tool.Y), Is.All.EqualTo(-Angle.Sin(40)).Within(1e-9));
    }

    [Test]
    public void Without_an_aim_the_upright_head_is_refused_on_the_side()
    {
        using var job = PrintJob.Draw(Lines().ToSteps(), Setup, Options with { Tilt = null }).OrThrow();
        Assert.That(PrintCheck.Run(job.Toolpath, job.Setup).Where(f => f.Severity == Severity.Error).Select(f => f.Code), Does.Contain("collision.nozzle"));
    }

    [Test]
    public void A_travel_stays_as_planned_where_it_hits_nothing_and_the_tool_leans_little()
    {
        var lean = new Vec3(0, 20, 0);
        var planned = new HeadMove[] { new(new(0, 0, 1), lean, new(0, 0, 9), lean), new(new(0, 0, 9), lean, new(30, 0, 1), default) };
        Assert.That(new LeaningTravels(Setup.Printer.Kinematics!, _ => false).Find(planned), Is.Null);
        Assert.That(new LeaningTravels(Setup.Printer.Kinematics!, _ => true).Find(planned), Is.Null, "nothing is better");
    }

    [Test]
    public void A_travel_goes_as_far_away_as_it_must()
    {
        // The tool lies level along +X: B 90.
        var level = new Vec3(0, 90, 0);
        var planned = new HeadMove[] { new(new(1, 0, 50), level, new(1, 0, 80), level), new(new(1, 0, 80), level, new(1, 6, 50), level) };
        var travels = new LeaningTravels(Setup.Printer.Kinematics!, head => head.To.X is > 1 and < 5 || head.From.X is > 1 and < 5);
        var found = travels.Find(planned)!;
        Vec3[] ends = [new(6, 0, 50), new(6, 6, 50), new(1, 6, 50)];
        Assert.That(found.Select((m, i) => m.To.DistanceTo(ends[i])), Is.All.LessThan(1e-9));
        Assert.That(found.Select(m => m.ToTurns), Is.All.EqualTo(level));
    }

    // mm in which the head hits something as it stands up: it goes on for no more than twice as far.
    [TestCase(6)]
    [TestCase(11)]
    [TestCase(21)]
    [TestCase(41)]
    public void The_tool_stands_up_as_near_to_the_bead_as_it_can(double needed)
    {
        var (from, level) = (new Vec3(1, 0, 50), new Vec3(0, 90, 0));
        var travels = new LeaningTravels(Setup.Printer.Kinematics!, head => head.FromTurns != head.ToTurns && head.To.DistanceTo(from) < needed);
        Assert.That(travels.StandUp(from, level, Vec3.Zero)[0].To.DistanceTo(from), Is.InRange(needed, 2 * needed));
    }

    [Test]
    public void Where_all_straight_travels_hit_the_tool_stands_up_and_goes_over_the_top()
    {
        var level = new Vec3(0, 90, 0);
        var planned = new HeadMove[] { new(new(1, 0, 50), level, new(1, 0, 80), level), new(new(1, 0, 80), level, new(-1, 0, 50), new(0, 90, 180)) };
        var found = new LeaningTravels(Setup.Printer.Kinematics!, head => head.From.X * head.To.X < 0 && Math.Min(head.From.Z, head.To.Z) < 80).Find(planned)!;
        Assert.That(found, Has.Count.EqualTo(5));
        Assert.That(found[1].To.DistanceTo(new Vec3(2, 0, 80)), Is.LessThan(1e-9));
        Assert.That(Setup.Printer.Kinematics!.Direction(found[1].ToTurns), Is.EqualTo(Vec3.UnitZ));
        Assert.That(found[4].To, Is.EqualTo(planned[1].To));
    }

    // The first place that is free, 5 mm away or more, along the tool; there it turns upright.
    [TestCase(0, 5)]
    [TestCase(7, 10)]
    [TestCase(500, 5)]
    public void A_leaning_tool_stands_up_where_it_is_free(double blocked, double away)
    {
        var kinematics = Setup.Printer.Kinematics!;
        var (from, words) = (new Vec3(100, 100, 20), new Vec3(0, 60, 0));
        var moves = new LeaningTravels(kinematics, head => head.To.DistanceTo(from) < blocked).StandUp(from, words, Vec3.Zero);
        Assert.That(moves.Select(m => (m.FromTurns, m.ToTurns)), Is.EqualTo(new[] { (words, words), (words, Vec3.Zero) }));
        Assert.That(moves.Select(m => (m.To - from - kinematics.Direction(words) * away).Length), Is.All.LessThan(1e-9));
    }

    [TestCase(false)]
    [TestCase(true)]
    public void Progress_ascends_to_1_whatever_number_of_leans_is_tried(bool isBuried)
    {
        var setup = Setup with { PrintedOn = isBuried ? Solids.Block(0, 0, 0, 200, 200, 90) : null };
        var plan = Planner.Plan(Lines().Take(2).ToSteps(), setup, new PlanOptions { Policy = PlanPolicy.AsDrawn }).OrThrow();
        var reported = new List<double>();
        TiltedTool.Apply(plan, setup, new ToolAim(Out) { Side = p => Vec3.Cross(Out(p), Vec3.UnitZ) }, new Progress(reported));
        Assert.That(reported, Has.Count.AtLeast(isBuried ? 6 : 2).And.Ordered.And.All.InRange(0.0, 1.0));
        Assert.That(reported.Last(), Is.EqualTo(1));
        Assert.That(reported.Any(r => r is > 0.5 and < 0.95), Is.EqualTo(isBuried));
    }

    private static PrintJobOptions Options => new() { Onto = Cone, InPlace = true, Tilt = new ToolAim(Out) };

    // Out of the cone, a tenth upward.
    private static Vec3 Out(Vec3 p) => new Vec3(p.X - Place.X, p.Y - Place.Y, 3).Unit();

    // Three rows of four lines, 0.1 mm outside of the cone, on half of its side.
    private static PrintPath[] Lines()
    {
        var lines = new List<PrintPath>();
        for (var row = 0; row < 3; row++)
        {
            for (var part = 0; part < 4; part++)
            {
                var (z, begin) = (60.0 + 4 * row, part * 45.0);
                var points = Enumerable.Range(0, 13).Select(k => At(begin + 2.5 * k, 30.1 - z / 10, z)).ToArray();
                lines.Add(new PrintPath(points, new Bead(0.08, 0.2, 30)));
            }
        }
        return [.. lines];
    }

    private static Vec3 At(double degrees, double radius, double z)
    {
        var (sin, cos) = Angle.SinCos(degrees);
        return Place + new Vec3(radius * cos, radius * sin, z);
    }

    // How the tool leans at the ends of the moves of a line on an object, in pieces of 2 mm.
    private static List<(Vec3 Place, double Lean, Vec3 Tool)> Leans(TriMesh on, Vec3[] line, ToolAim aim)
    {
        var parts = (int)Math.Ceiling(line[0].DistanceTo(line[1]) / 2);
        var points = Enumerable.Range(0, parts + 1).Select(i => Vec3.Lerp(line[0], line[1], (double)i / parts));
        var setup = Setup with { PrintedOn = on };
        var plan = Planner.Plan([new PathStep(new PrintPath(points, new Bead(0.08, 0.2)))], setup, new PlanOptions { Policy = PlanPolicy.AsDrawn }).OrThrow();
        var leaning = TiltedTool.Apply(plan, setup, aim);
        var kinematics = Setup.Printer.Kinematics!;
        return leaning.Moves().Where(m => m.Kind == MoveKind.Print).Select(m => (m.End, kinematics.Direction(leaning.WordsAt(m.Index))))
            .Select(m => (m.Item1, Angle.Atan2(m.Item2.LengthXY, m.Item2.Z), m.Item2)).ToList();
    }

    private sealed class Progress(List<double> reported) : IProgress<double>
    {
        public void Report(double value) => reported.Add(value);
    }
}
