using System;
using System.Collections.Generic;
using System.Linq;
using System.Text;
using Caterpillar.Basics;
using Caterpillar.Drawings;
using Caterpillar.Geometry;
using Caterpillar.Machines;
using Caterpillar.Planning;
using Caterpillar.Toolpaths;
using NUnit.Framework;

namespace Caterpillar.Tests.Drawings;

/// <summary>Dots of material extruded in place, and values that step from point to point.</summary>
internal sealed class DotAndStepTests
{
    private static readonly CurveOptions Plain = new() { Shape = BeadShape.Rectangle };

    private static IReadOnlyList<UserCurve> Read(string text, string name) => CurveReader.Read(Encoding.UTF8.GetBytes(text), name).OrThrow();

    private static string Text(IEnumerable<Step> steps) => string.Join(" ", steps.Select(s => s switch
    {
        PathStep p => $"path {p.Path.Start.X:0.#}-{p.Path.End.X:0.#}",
        TravelStep t => $"to {t.Points.Single().X:0.#}",
        EventStep { Event: ExtrudeEvent { IsDot: true } e } => $"dot {e.Volume:0.#}@{e.Speed:0.#}",
        _ => "?",
    }));

    private static string Steps(string text, string name = "a.csv", CurveOptions? options = null)
    {
        var before = System.Threading.Thread.CurrentThread.CurrentCulture;
        System.Threading.Thread.CurrentThread.CurrentCulture = System.Globalization.CultureInfo.InvariantCulture;
        try
        {
            return Text(CurvePaths.ToSteps(Read(text, name), options ?? Plain).OrThrow());
        }
        finally
        {
            System.Threading.Thread.CurrentThread.CurrentCulture = before;
        }
    }

    [TestCase("x,y,z,dot\n10,0,1,0\n20,0,1,3\n30,5,1,0", "path 10-20 to 20 dot 3@2 path 20-30")]
    [TestCase("x,y,z,dot\n10,0,1,2\n20,0,1,0\n30,5,1,4", "to 10 dot 2@2 path 10-30 to 30 dot 4@2")]
    [TestCase("x,y,z,blob_mm3\n10,0,1,2\n\n20,0,1,3\n\n30,0,1,0\n40,0,1,0", "to 10 dot 2@2 to 20 dot 3@2 path 30-40")]
    [TestCase("x,y,z,dot\n10,0,1,1\n10,0,1,2\n20,0,1,0", "to 10 dot 1@2 to 10 dot 2@2 path 10-20", TestName = "Of two dots at one point both count")]
    [TestCase("x,y,z,dot,width\n10,0,1,0,0.4\n20,0,1,1,0.4\n30,0,1,0,0.8", "path 10-20 to 20 dot 1@2 path 20-30")]
    public void A_column_of_a_csv_places_dots(string text, string expected) => Assert.That(Steps(text), Is.EqualTo(expected));

    [Test]
    public void Values_of_columns_stay_with_their_points_between_dots()
    {
        var steps = CurvePaths.ToSteps(Read("x,y,z,dot,width\n10,0,1,0,0.4\n20,0,1,1,0.4\n30,0,1,0,0.8\n", "a.csv"), Plain with { Height = 1, Steps = true })
            .OrThrow();
        var paths = steps.OfType<PathStep>().Select(s => s.Path).ToArray();
        Assert.That(paths.Select(p => p.BeadOf(0).Area), Is.EqualTo(new[] { 0.4, 0.4 }).Within(1e-12));
    }

    [TestCase("{\"curves\": [{\"points\": [[10,0],[20,0]], \"dot\": 3}, {\"points\": [[30,0,1]], \"dot\": 2}]}", "to 10 dot 3@2 path 10-20 to 30 dot 2@2")]
    [TestCase("[[[10,0],[20,0]]]", "path 10-20")]
    public void Json_has_dots_at_the_start_of_curves(string text, string expected) => Assert.That(Steps(text, "a.json"), Is.EqualTo(expected));

    [Test]
    public void Every_point_may_be_a_dot()
    {
        var dots = Plain with { Dots = 1.5, DotSpeed = 3 };
        Assert.That(Steps("10,0,1\n20,0,1\n30,0,1", "a.csv", dots), Is.EqualTo("to 10 dot 1.5@3 to 20 dot 1.5@3 to 30 dot 1.5@3"));
        Assert.That(CurvePaths.ToPaths(Read("10,0,1\n20,0,1", "a.csv"), dots).OrThrow(), Has.Count.EqualTo(1), "paths have no dots");
    }

    [TestCase("{\"points\": [[0,0],[1,0]], \"dot\": -3}", "a.json", "curves.json")]
    [TestCase("{\"points\": [[0,0],[1,0]], \"dot\": \"much\"}", "a.json", "curves.json")]
    [TestCase("x,y,dot\n0,0,-1", "a.csv", "curves.bead")]
    [TestCase("x,y,dot\n0,0,5%", "a.csv", "curves.percent")]
    public void Wrong_dots_are_errors(string text, string name, string code)
        => Assert.That(CurveReader.Read(Encoding.UTF8.GetBytes(text), name).Diagnostics.Single().Code, Is.EqualTo(code));

    [Test]
    public void A_dot_without_end_is_an_error()
        => Assert.That(CurvePaths.ToSteps([UserCurve.DotAt(Vec3.Zero, double.PositiveInfinity)]).Diagnostics.Single().Code, Is.EqualTo("curves.bead"));

    [Test]
    public void A_planned_dot_is_deposited_whole_after_a_retraction()
    {
        var setup = new PrintSetup();
        var steps = CurvePaths.ToSteps(Read("x,y,z,dot\n10,10,0.2,0\n60,10,0.2,0\n\n10,50,0.2,2\n\n60,50,0.2,3", "a.csv"), Plain).OrThrow();
        var toolpath = Planner.Plan(steps, setup).OrThrow();
        var kinds = Enumerable.Range(0, toolpath.Count).Select(i => toolpath[i]).ToArray();
        var primes = kinds.Where(m => m.Kind == MoveKind.Prime).ToArray();
        var area = Math.PI * 0.875 * 0.875;
        Assert.That(primes.Select(m => m.Deposited * area), Is.EqualTo(new[] { 2.0, 3 }).Within(1e-9));
        Assert.That(kinds.Count(m => m.Kind == MoveKind.Retract), Is.GreaterThanOrEqualTo(2));
        Assert.That(primes.Select(m => m.End.X), Is.EqualTo(new[] { 10.0, 60 }));
    }

    [Test]
    public void Values_hold_from_their_point_to_the_next()
    {
        var text = "x,y,z,width\n0,0,1,0.4\n10,0,1,0.8\n20,0,1,0.6\n30,0,1,0.5";
        var path = CurvePaths.ToPaths(Read(text, "a.csv"), Plain with { Height = 1, Steps = true }).OrThrow().Single();
        Assert.That(path.Points.Select(p => p.X), Is.EqualTo(new[] { 0.0, 10, 20, 30 }));
        Assert.That(Enumerable.Range(0, 3).Select(i => path.BeadOf(i).Area), Is.EqualTo(new[] { 0.4, 0.8, 0.6 }).Within(1e-12));
        Assert.That(CurvePaths.ToPaths(Read(text, "a.csv"), Plain).OrThrow().Single().SegmentCount, Is.GreaterThan(8), "without the option they ramp");
    }

    [Test]
    public void On_a_curve_without_vertices_values_step_at_equal_lengths()
    {
        var line = new UserCurve(new PolylineCurve([Vec3.Zero, new Vec3(40, 0, 0)])) { Along = new PointValues(widths: [0.4, 0.8, 0.6]) };
        var path = CurvePaths.ToPaths([line], Plain with { Height = 1, Steps = true }).OrThrow().Single();
        Assert.That(path.Points.Select(p => p.X), Is.EqualTo(new[] { 0.0, 20, 40 }).Within(1e-9));
        Assert.That(Enumerable.Range(0, 2).Select(i => path.BeadOf(i).Area), Is.EqualTo(new[] { 0.4, 0.8 }).Within(1e-12));
    }
}
