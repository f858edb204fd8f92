using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using Caterpillar.Basics;
using Caterpillar.Geometry;
using Caterpillar.Toolpaths;
using FsCheck;
using FsCheck.Fluent;
using Newtonsoft.Json.Linq;
using NUnit.Framework;

namespace Caterpillar.Tests.Toolpaths;

/// <summary>Nine kinds of machines, with words that an independent program has computed.</summary>
public class KinematicsTests
{
    // The vectors have nine decimals, directions twelve.
    private const double Rounded = 2e-9;

    private static readonly Lazy<JObject> Data = new(() => JObject.Parse(File.ReadAllText(TestData.Shared("kinematics.json"))));

    private static readonly string[] Machines =
    [
        "head_bc", "head_ac", "table_ac", "table_bc", "table_bc_turned", "mixed_b_head_c_table", "polar_b_head_c_platform", "platform_c", "rotary_a",
    ];

    [TestCaseSource(nameof(Machines))]
    public void Words_of_each_frame_are_those_of_the_vectors(string id)
    {
        var (machine, kinematics) = Machine(id);
        foreach (var frame in machine["frames"]!)
        {
            var (tip, tool) = (Vector(frame[0]!), Vector(frame[1]!));
            var isFree = frame.Count() > 3;
            var wanted = frame[2]!.Select(s => Words(machine, s)).ToArray();
            var found = kinematics.Solutions(tip, tool);
            foreach (var (slides, turns) in wanted)
            {
                var nearest = found.OrderBy(f => Distance(f, turns)).First();
                if (!isFree) Assert.That(Distance(nearest, turns), Is.LessThan(1e-7), $"{id} {frame[0]}: the directions have twelve decimals");
                Assert.That(kinematics.Machine(tip, turns).DistanceTo(slides), Is.LessThan(Rounded * 50), $"{id} {frame[0]}: words have nine decimals");
                Assert.That(kinematics.Tip(slides, turns).DistanceTo(tip), Is.LessThan(Rounded * 50));
                Assert.That(kinematics.Direction(turns).DistanceTo(tool), Is.LessThan(1e-9));
            }
            if (!isFree) Assert.That(found, Has.Count.EqualTo(wanted.Length), $"{id} {frame[0]}");
        }
    }

    [TestCaseSource(nameof(Machines))]
    public void A_path_is_followed_by_the_smallest_turns_within_the_limits(string id)
    {
        var (machine, kinematics) = Machine(id);
        var last = Vec3.Zero;
        foreach (var pose in machine["chain"]!)
        {
            var (tip, tool) = (Vector(pose[0]!), Vector(pose[1]!));
            var (slides, turns) = Words(machine, pose[2]!);
            // Turns that are as small are not told apart by the last decimals.
            last = kinematics.Nearest(tip, tool, last);
            Assert.That((last - turns).Length, Is.LessThan(1e-6), $"{id} {pose[0]}: {last} {turns}");
            Assert.That(kinematics.Machine(tip, last).DistanceTo(slides), Is.LessThan(1e-6));
            last = turns;
        }
    }

    [TestCaseSource(nameof(Machines))]
    public void Moves_are_divided_so_that_the_tip_stays_within_a_hundredth_of_a_millimeter(string id)
    {
        var (machine, kinematics) = Machine(id);
        foreach (var move in machine["moves"]!)
        {
            var ((from, turns), (to, toTurns)) = (Words(machine, move["words0"]!), Words(machine, move["words1"]!));
            var (a, b) = (Vector(move["p0"]!), Vector(move["p1"]!));
            Vec3 Tip(double s) => kinematics.Tip(Vec3.Lerp(from, to, s), Vec3.Lerp(turns, toTurns, s));
            var deviation = Enumerable.Range(0, 201).Max(k => Tip(k / 200.0).DistanceToSegment(a, b));
            var wanted = (double)move["deviation_mm"]!;
            Assert.That(Tip((double)move["at"]!).DistanceToSegment(a, b), Is.EqualTo(wanted).Within(2e-6), id);
            Assert.That(deviation, Is.InRange(0.999 * wanted - 2e-6, wanted + 2e-6), id);
            if (kinematics.IsPolar) continue;
            var count = MachinePositions.Divisions(kinematics, a, turns, b, toTurns);
            // Theirs counts the distance from the path alone, ours what lags along it too, and leaves a fifth for rounding.
            Assert.That(count, Is.InRange((int)move["divisions"]!, 2 + (int)Math.Sqrt((double)move["lag_mm"]! / 0.008)), $"{id} {move["lag_mm"]}");
            for (var k = 0; k < count; k++)
            {
                (Vec3 Slides, Vec3 Turns) At(double s)
                    => (kinematics.Machine(Vec3.Lerp(a, b, s), Vec3.Lerp(turns, toTurns, s)), Vec3.Lerp(turns, toTurns, s));
                var (start, end) = (At((double)k / count), At((k + 1.0) / count));
                for (var s = 0.05; s < 1; s += 0.05)
                {
                    var tip = kinematics.Tip(Vec3.Lerp(start.Slides, end.Slides, s), Vec3.Lerp(start.Turns, end.Turns, s));
                    Assert.That(tip.DistanceToSegment(a, b), Is.LessThan(MachinePositions.Tolerance));
                }
            }
        }
    }

    // Both solutions turn one of the axes by 90 degrees; one leaves the other as it is.
    [Test]
    public void Of_turns_with_the_same_largest_the_one_with_the_smaller_sum_is_taken()
    {
        var kinematics = new Kinematics([RotaryAxis.Parse("C head z")!, RotaryAxis.Parse("B head y at 0 0 60")!]);
        Assert.That(kinematics.Change(new Vec3(0, 10, 20), new Vec3(0, 40, -30)), Is.EqualTo((50.0, 80.0)));
        var turns = kinematics.Nearest(Vec3.Zero, new Vec3(Angle.Sin(30), 0, Angle.Cos(30)), new Vec3(0, 60, 90));
        Assert.That(turns.DistanceTo(new Vec3(0, 30, 0)), Is.LessThan(1e-9));
    }

    [TestCase(1, 0.411)]
    [TestCase(5, 20.1)]
    [TestCase(0.001, 0.013)]
    public void A_speed_that_the_axes_hold_is_not_rounded_up_beyond_it_in_the_file(double length, double time)
    {
        var written = Math.Round(MachinePositions.Held(1000, length, time) * 60) / 60;
        Assert.That(written, Is.LessThanOrEqualTo(length / time).And.GreaterThan(0.3 * length / time));
    }

    [TestCaseSource(nameof(Machines))]
    public void Forward_undoes_inverse_for_random_frames(string id)
    {
        var (machine, kinematics) = Machine(id);
        var hasTilt = kinematics.Tilts;
        Gen<double> Number(double most) => Gen.Choose(-1_000_000, 1_000_000).Select(n => n / 1_000_000.0 * most);
        var frames = from x in Number(200) from y in Number(200) from z in Number(200) from tilt in Number(180) from turn in Number(180)
            select (new Vec3(x, y, z), tilt, turn);
        Prop.ForAll(frames.ToArbitrary(), f =>
        {
            var (tip, tilt, turn) = f;
            // What the machine can do: in the plane of its only tilt, or of a polar machine, and upright without any.
            var tool = !hasTilt ? Vec3.UnitZ
                : id == "rotary_a" ? new Vec3(0, -Angle.Sin(tilt), Angle.Cos(tilt))
                : kinematics.IsPolar ? (new Vec3(tip.X, tip.Y).Unit() * Angle.Sin(tilt)).WithZ(Angle.Cos(tilt))
                : new Vec3(Angle.Sin(tilt) * Angle.Cos(turn), Angle.Sin(tilt) * Angle.Sin(turn), Angle.Cos(tilt));
            foreach (var words in kinematics.Solutions(tip, tool, new Vec3(7, 11, 13)))
            {
                var slides = kinematics.Machine(tip, words);
                if (kinematics.IsPolar && Math.Abs(slides.Y) > 1e-9) return false;
                if (!(kinematics.Tip(slides, words).DistanceTo(tip) < 1e-9 && kinematics.Direction(words).DistanceTo(tool) < 1e-9)) return false;
                var pose = kinematics.Pose(tip, words);
                if (!(Math.Abs(pose.Determinant - 1) < 1e-12 && pose.ZAxis == kinematics.Direction(words))) return false;
            }
            return true;
        }).Check(Config.QuickThrowOnFailure.WithMaxTest(Rounds.Of(200, 2000)).WithReplay(11, 13));
    }

    [Test]
    public void A_pole_is_passed_by_holding_the_turn()
    {
        var (_, kinematics) = Machine("head_bc");
        var last = new Vec3(0, 20, 30);
        for (var tilt = 19.9; tilt > -20; tilt -= 0.1)
        {
            var tool = new Vec3(Angle.Sin(tilt) * Angle.Cos(30), Angle.Sin(tilt) * Angle.Sin(30), Angle.Cos(tilt));
            var next = kinematics.Nearest(Vec3.Zero, tool, last);
            Assert.That(next.Z, Is.EqualTo(30).Within(1e-6), "C holds");
            Assert.That(next.Y, Is.EqualTo(Math.Abs(tilt) < 0.05 ? 0 : tilt).Within(1e-6), "B goes through zero");
            last = next;
        }
    }

    [TestCase("B head y at 0 0 42.5 from -110 to 110 speed 60 acceleration 500")]
    [TestCase("C work -z at 110 110 0 speed 90")]
    [TestCase("A work x")]
    public void An_axis_is_read_as_it_is_written(string text)
    {
        var axis = RotaryAxis.Parse(text)!;
        Assert.That((axis.ToString(), RotaryAxis.Parse(axis.ToString())), Is.EqualTo((text, axis)));
    }

    [TestCase("")]
    [TestCase("D head y")]
    [TestCase("B table y")]
    [TestCase("B head w")]
    [TestCase("B head y at 1 2")]
    [TestCase("B head y from 10 to -10")]
    [TestCase("B head y from 10 to 10")]
    [TestCase("B head y speed 0")]
    [TestCase("B head y quickly 4")]
    public void Another_text_is_no_axis(string text) => Assert.That(RotaryAxis.Parse(text), Is.Null);

    [Test]
    public void Axes_that_make_no_such_machine_are_told()
    {
        static string? Problem(params string[] axes) => Kinematics.Problem([.. axes.Select(a => RotaryAxis.Parse(a)!)]);
        Assert.That(Problem("C head z", "B head y"), Is.Null);
        Assert.That(Problem("B head y", "C head z"), Does.Contain("does not turn the tilt"));
        Assert.That(Problem("B work y", "C work z"), Is.Null);
        Assert.That(Problem("B head y", "B work z"), Does.Contain("twice"));
        Assert.That(Problem("A head x", "B head y"), Does.Contain("one axis about z and one"));
    }

    [Test]
    public void Of_rotary_words_alone_the_usual_machine_is_guessed()
    {
        static Kinematics? Guess(params Vec3[] words)
        {
            var builder = new ToolpathBuilder(MoveSource.Lines, Vec3.Zero);
            foreach (var turns in words)
            {
                builder.Add(new Vec3(1, 0), 0, 0, 10, MoveKind.Travel, Role.Unspecified, -1, 0, 0);
                if (turns != Vec3.Zero) builder.SetRotary(turns);
            }
            return Kinematics.Guess(builder.Build([]));
        }
        Assert.That(Guess(new Vec3(10, 0, 0), new Vec3(0, 0, 20))!.Axes.Select(a => a.Word), Is.EqualTo(new[] { RotaryWord.C, RotaryWord.A }));
        Assert.That(Guess(new Vec3(0, 10, 0))!.Axes.Select(a => a.Word), Is.EqualTo(new[] { RotaryWord.C, RotaryWord.B }));
        Assert.That(Guess(new Vec3(10, 10, 0)), Is.Null, "both tilt");
        Assert.That(Guess(Vec3.Zero), Is.Null, "nothing turns");
    }

    internal static (JToken Machine, Kinematics Kinematics) Machine(string id)
    {
        var machine = Data.Value["machines"]!.First(m => (string)m["id"]! == id);
        RotaryAxis Axis(string word, bool isWork)
        {
            var limits = machine["limits"]![word]!;
            return new RotaryAxis((RotaryWord)"ABC".IndexOf(word, StringComparison.Ordinal), isWork, (PathAxis)"ABC".IndexOf(word, StringComparison.Ordinal),
                Vector(machine["points"]![word]!))
            {
                IsReversed = (int)machine["sense"]![word]! < 0,
                Min = limits.HasValues ? (double)limits[0]! : double.NegativeInfinity,
                Max = limits.HasValues ? (double)limits[1]! : double.PositiveInfinity,
            };
        }
        RotaryAxis[] axes = [.. machine["head"]!.Select(w => Axis((string)w!, false)), .. machine["work"]!.Select(w => Axis((string)w!, true))];
        return (machine, new Kinematics(axes, (bool)machine["polar"]!));
    }

    [TestCase("C head z;B head y", 2)]
    [TestCase("C head z;A head x", 1)]
    [TestCase("A work x;C work z", 1)]
    [TestCase("B head y;C work z", 2)]
    public void A_tool_bends_by_no_more_than_is_said(string text, int tilt)
    {
        var kinematics = new Kinematics([.. text.Split(';').Select(a => RotaryAxis.Parse(a)!)]);
        Vec3 Turned(double lean, double turn) => tilt == 1 ? new Vec3(lean, 0, turn) : new Vec3(0, lean, turn);
        Assert.That(kinematics.ToolTurn(Turned(0, 20), Turned(0, 200)), Is.EqualTo((0.0, 0.0)), "upright it only turns about itself");
        Assert.That(kinematics.ToolTurn(Turned(10, 0), Turned(100, 0)).Angle, Is.EqualTo(Math.PI / 2).Within(1e-12));
        Assert.That(kinematics.ToolTurn(Turned(90, 0), Turned(90, 180)).Angle, Is.EqualTo(Math.Sqrt(2) * Math.PI).Within(1e-12));
        var random = new Random(3);
        double Next(double most) => most * (2 * random.NextDouble() - 1);
        for (var round = 0; round < 300; round++)
        {
            var from = Turned(Next(round % 3 == 0 ? 3 : 120), Next(180));
            var to = from + Turned(Next(30), Next(round % 2 == 0 ? 20 : 180));
            var (angle, bend) = kinematics.ToolTurn(from, to);
            var (first, last, swept, before) = (kinematics.Direction(from), kinematics.Direction(to), 0.0, kinematics.Direction(from));
            for (var k = 1; k <= 64; k++)
            {
                var now = kinematics.Direction(Vec3.Lerp(from, to, k / 64.0));
                swept += now.DistanceTo(before);
                before = now;
                var apart = now.DistanceTo(Vec3.Lerp(first, last, k / 64.0));
                if (apart > bend / 8 + 1e-12) Assert.Fail($"round {round}: {apart} from the chord, {bend / 8} is said");
            }
            if (swept > angle + 1e-12) Assert.Fail($"round {round}: it swings by {swept}, {angle} is said");
        }
    }

    private static Vec3 Vector(JToken t) => new((double)t[0]!, (double)t[1]!, (double)t[2]!);

    private static (Vec3 Slides, Vec3 Turns) Words(JToken machine, JToken words)
    {
        var order = machine["order"]!.Select(w => (string)w!).ToList();
        double Of(string name) => order.IndexOf(name) is >= 0 and var i ? (double)words[i]! : 0;
        return (new Vec3(Of("X"), Of("Y"), Of("Z")), new Vec3(Of("A"), Of("B"), Of("C")));
    }

    // Up to full turns, degrees.
    private static double Distance(Vec3 a, Vec3 b)
    {
        static double Turn(double d) => Math.Abs(d - 360 * Math.Floor(d / 360 + 0.5));
        return Turn(a.X - b.X) + Turn(a.Y - b.Y) + Turn(a.Z - b.Z);
    }
}
