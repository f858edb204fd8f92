using System;
using System.Collections.Generic;
using System.Linq;
using Caterpillar.Geometry;
using Caterpillar.Machines;
using Caterpillar.Planning;
using Caterpillar.Toolpaths;
using Caterpillar.Turtles;
using NUnit.Framework;

namespace Caterpillar.Tests.Turtles;

/// <summary>Returns from branches, resolved by planning, checked against every extrusion by brute force.</summary>
[Category("Arithmetic")]
internal sealed class SafeReturnTests
{
    private const string Tree =
        "param levels = 7\nstart 110 40 0.3\nleft 90\n"
        + "def branch n d [ forward d, 0.4; if n > 0 [ push; left 31; branch n-1 d*0.74; pop; push; right 37; branch n-1 d*0.74; pop ] ]\nbranch levels 30";

    private static Toolpath Plan(string script, params string[] settings)
    {
        var turtle = TurtleScript.Compile(script).Value!.Run().Value!;
        return Planner.Plan(turtle.ToSteps(), new PrintSetup().With(settings).Value!).Value!;
    }

    [TestCase("z_hop_type=above_print")]
    [TestCase("z_hop_type=above_path")]
    public void Travel_of_a_climbing_tree_never_goes_through_an_extrusion(string setting)
    {
        var moves = Plan(Tree, setting).Moves().ToArray();
        var worst = Worst(moves);
        Assert.That(moves.Count(m => m.Kind == MoveKind.Print), Is.EqualTo(255));
        // Where branches begin, extrusions of the same height lie side by side.
        Assert.That(worst, Is.LessThan(0.08));
        var drawn = Planner.Plan(TurtleScript.Compile(Tree).Value!.Run().Value!.ToSteps(), new PrintSetup(), new PlanOptions { Policy = PlanPolicy.AsDrawn })
            .Value!.Moves().ToArray();
        Assert.That(drawn.Where(m => m.Kind == MoveKind.Print).Sum(m => m.Length),
            Is.EqualTo(moves.Where(m => m.Kind == MoveKind.Print).Sum(m => m.Length)).Within(1e-9));
        Assert.That(Worst(drawn), Is.LessThan(0.08));
        // The measure works: straight returns do go through extrusions.
        var prints = moves.Where(m => m.Kind == MoveKind.Print).ToArray();
        var straight = prints.Zip(prints.Skip(1), (a, b) => new[] { a, a with { Start = a.End, End = b.Start, Kind = MoveKind.Travel } }).SelectMany(p => p);
        Assert.That(Worst(straight), Is.GreaterThan(0.3));
    }

    [Test]
    public void Returning_restores_everything_that_was_retracted()
    {
        var moves = Plan(Tree).Moves().ToArray();
        Assert.That(moves.Where(m => m.Kind is MoveKind.Retract or MoveKind.Deretract).Sum(m => m.E), Is.LessThanOrEqualTo(1e-9).And.GreaterThanOrEqualTo(-5));
        Assert.That(moves.Where(m => m.Kind == MoveKind.Print).Sum(m => m.E),
            Is.EqualTo(moves.Where(m => m.Kind == MoveKind.Print).Sum(m => m.Length) * 0.05).Within(1e-9));
    }

    private static double Worst(IEnumerable<Move> moves)
    {
        var printed = new List<(Vec3 A, Vec3 B)>();
        var worst = 0.0;
        foreach (var move in moves)
        {
            if (move.Kind == MoveKind.Print) printed.Add((move.Start, move.End));
            else if (move.Length > 0) worst = Math.Max(worst, Depth(move.Start, move.End, printed));
        }
        return worst;
    }

    // How far below the top of an extrusion the nozzle (0.4 mm) passes, at most.
    private static double Depth(Vec3 from, Vec3 to, List<(Vec3 A, Vec3 B)> extrusions)
    {
        var worst = 0.0;
        var count = Math.Max(1, (int)(from.DistanceTo(to) / 0.3));
        for (var i = 0; i <= count; i++)
        {
            var p = Vec3.Lerp(from, to, (double)i / count);
            foreach (var (a, b) in extrusions)
            {
                if (Math.Max(a.Z, b.Z) - p.Z <= worst) continue;
                var ab = (b - a).WithZ(0);
                var t = ab.LengthSquared > 0 ? Math.Min(Math.Max(Vec3.Dot((p - a).WithZ(0), ab) / ab.LengthSquared, 0), 1) : 0;
                var q = Vec3.Lerp(a, b, t);
                if ((q - p).LengthXY < 0.2) worst = Math.Max(worst, q.Z - p.Z);
            }
        }
        return worst;
    }
}
