using System;
using System.Linq;
using System.Text;
using Caterpillar.Basics;
using Caterpillar.Checks;
using Caterpillar.Geometry;
using Caterpillar.Machines;
using Caterpillar.Planning;
using Caterpillar.Toolpaths;
using Caterpillar.Turtles;
using NUnit.Framework;

namespace Caterpillar.Tests.Turtles;

/// <summary>Branching programs: no return is refused by the checks unless planning has said at its line that it cannot be.</summary>
public class BranchTests
{
    private static readonly PrintSetup Setup = new()
    {
        Printer = new Printer
        {
            BuildVolume = new Vec3(1000, 1000, 1000), Origin = BedOrigin.Center,
            CheckSeverities = new([.. CheckCodes.All.Where(r => r.Code != CheckCodes.TravelHits).Select(r => new CheckSeverity(r.Code, null))]),
        },
    };

    // Branches that climb, sink, cross each other and lie flat.
    [Category("Arithmetic")]
    [Test]
    public void Random_branches_return_through_nothing_or_say_so([Values] PlanPolicy policy)
    {
        int said = 0, silent = 0;
        for (var round = 0; round < Rounds.Of(120, 2000); round++)
        {
            var text = new StringBuilder("start 0 0 40\narea 0.12 0.3\nforward 10\n");
            Grow(new Random(round), text, 0);
            var (blocked, hits) = Run(text.ToString(), policy);
            if (blocked.Length > 0) said++;
            else if (hits is not null) Assert.Fail($"{hits}\n{text}");
            else silent++;
        }
        Assert.That(said, Is.GreaterThan(10));
        Assert.That(silent, Is.GreaterThan(10));
    }

    [TestCase(20, 0)]
    [TestCase(25, 0)]
    [TestCase(60, 1)]
    public void A_branch_that_is_too_steep_to_return_to_its_foot_is_said_at_its_line(double pitch, int said)
    {
        var text = $"start 0 0 0.3\narea 0.12 0.3\nforward 20\npush\npitch {pitch}\nforward 6\npop\nforward 10\n";
        foreach (PlanPolicy policy in Enum.GetValues(typeof(PlanPolicy)))
        {
            var (blocked, hits) = Run(text, policy);
            Assert.That(blocked.Select(d => d.Source!.Line), Is.EqualTo(Enumerable.Repeat((int?)7, said)));
            Assert.That(hits is not null, Is.EqualTo(said > 0));
        }
    }

    private static (Diagnostic[] Blocked, Diagnostic? Hits) Run(string text, PlanPolicy policy)
    {
        var steps = TurtleScript.Compile(text).OrThrow().Run(TurtleOptions.For(Setup)).OrThrow().ToSteps();
        var plan = Planner.PlanWithReport(steps, Setup, new PlanOptions { Policy = policy });
        var blocked = plan.Diagnostics.Where(d => d.Code == "plan.blocked_return").ToArray();
        return (blocked, PrintCheck.Run(plan.OrThrow().Toolpath, Setup).SingleOrDefault(d => d.Code == CheckCodes.TravelHits));
    }

    private static void Grow(Random random, StringBuilder text, int depth)
    {
        for (var branch = random.Next(1, 3); branch > 0; branch--)
        {
            text.Append("push\n");
            for (var part = random.Next(1, 3); part > 0; part--)
            {
                text.Append("yaw ").Append(random.Next(-60, 61)).Append("\npitch ").Append(random.Next(3) * 9 - 9).Append("\nforward ")
                    .Append(random.Next(2, 9)).Append('\n');
                if (depth < 2) Grow(random, text, depth + 1 + random.Next(2));
            }
            text.Append("pop\n");
        }
    }
}
