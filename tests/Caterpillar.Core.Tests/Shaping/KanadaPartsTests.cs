using System;
using System.IO;
using System.Linq;
using Caterpillar.Basics;
using Caterpillar.Geometry;
using Caterpillar.Shaping;
using Caterpillar.Toolpaths;
using Caterpillar.Traces;
using Newtonsoft.Json.Linq;
using NUnit.Framework;

namespace Caterpillar.Tests.Shaping;

/// <summary>The parts of Kanada's 2016 paper against numbers of an independent computation.</summary>
public class KanadaPartsTests
{
    private const double FilamentArea = Math.PI * 0.875 * 0.875;

    [TestCase("sphere_program", 72)]
    [TestCase("sphere_program", 300)]
    [TestCase("sphere_figure7", 72)]
    [TestCase("sphere_figure7", 300)]
    [TestCase("heart", 72)]
    [TestCase("heart", 300)]
    public void A_deformed_helix_has_the_strings_that_the_paper_gives_it(string part, int perTurn)
    {
        var truth = JObject.Parse(File.ReadAllText(TestData.Shared("turtle/kanada_traces.json")))["parts"]![part]!["strings_per_turn_" + perTurn]!;
        var (trace, deformation) = Part(part, perTurn);
        Compare(trace.ToPaths().Single(), truth["before"]!, 1e-8);
        var after = deformation.Apply(trace.ToPaths());
        Assert.That(after.Diagnostics, Is.Empty);
        Compare(after.Value!.Single(), truth["after"]!, part == "heart" ? 1e-5 : 1e-8);
    }

    private static (Trace, Deformation) Part(string name, int perTurn)
    {
        double radius = name == "sphere_figure7" ? 20 : 25, h = Math.PI / 2 * radius;
        var sphere = new PositionMap(p => new Vec3(radius * Angle.Sin(180 * p.Z / h), p.Y, p.X - radius * Angle.Cos(180 * p.Z / h)));
        return name switch
        {
            "sphere_program" => (
                new Trace(0.196).SetSpeed(36).Helix(Vec3.Zero, radius, h, 0.2, perTurn),
                Deformation.Cylindrical(sphere, area: (c, p) => 0.35 * ((0.5 * p.X + radius) / radius) * c)
                    .Then(Deformation.Cylindrical(
                        p => p + new Vec3(0, 0, 0.4), area: (c, _) => 2 * c, speed: (v, p) => 0.6 * (Math.Pow(p.X / radius, 1.5) + 0.2) * v))),
            "sphere_figure7" => (
                new Trace(0.196).SetSpeed(30).Helix(Vec3.Zero, radius, h, 0.4, perTurn),
                Deformation.Cylindrical(sphere, (c, _) => 1.2 * c, (v, p) => 1.2 * (Square(radius * Angle.Sin(180 * p.Z / h) / radius) + 0.1) * v)),
            _ => (
                new Trace(0.196).SetSpeed(25).Helix(Vec3.Zero, 25, 20, 0.4, perTurn),
                Deformation.Cartesian(p => new Vec3(p.X + 0.6 * p.Z * Math.Sqrt(Math.Abs(p.Y) / 25), p.Y, p.Z))),
        };
    }

    private static double Square(double x) => x * x;

    private static void Compare(PrintPath path, JToken truth, double tolerance)
    {
        Assert.That(path.SegmentCount, Is.EqualTo((int)truth["strings"]!));
        var segments = Enumerable.Range(0, path.SegmentCount).ToArray();
        Assert.That(path.Length, Is.EqualTo((double)truth["length"]!).Within(tolerance * path.Length));
        Assert.That(segments.Sum(i => path.LengthOf(i) * path.BeadOf(i).Area) / FilamentArea, Is.EqualTo((double)truth["e"]!).Within(tolerance * 1e4));
        Assert.That(segments.Sum(i => path.LengthOf(i) / path.BeadOf(i).Speed), Is.EqualTo((double)truth["time_s"]!).Within(tolerance * 1e4));
        Assert.That(path.Start.DistanceTo(Point(truth["start"]!)), Is.LessThan(Math.Max(tolerance, 2e-8)));
        Assert.That(path.End.DistanceTo(Point(truth["end"]!)), Is.LessThan(Math.Max(tolerance, 2e-8)));
        Assert.That(path.Bounds.Min.DistanceTo(Point(truth["bbox"]![0]!)), Is.LessThan(Math.Max(tolerance, 2e-8)));
        Assert.That(path.Bounds.Max.DistanceTo(Point(truth["bbox"]![1]!)), Is.LessThan(Math.Max(tolerance, 2e-8)));
        foreach (var sample in truth["samples"] ?? new JArray())
        {
            var i = (int)sample["i"]!;
            Assert.That(path.Points[i].DistanceTo(Point(sample["start"]!)), Is.LessThan(Math.Max(tolerance, 2e-8)));
            Assert.That(path.BeadOf(i).Area, Is.EqualTo((double)sample["area"]!).Within(1e-9));
            Assert.That(path.BeadOf(i).Speed, Is.EqualTo((double)sample["speed"]!).Within(Math.Max(tolerance, 1e-8)));
            Assert.That(path.LengthOf(i), Is.EqualTo((double)sample["length"]!).Within(Math.Max(tolerance, 1e-8)));
        }
    }

    private static Vec3 Point(JToken token) => new((double)token[0]!, (double)token[1]!, (double)token[2]!);
}
