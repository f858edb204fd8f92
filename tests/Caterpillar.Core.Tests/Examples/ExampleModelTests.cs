using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using Caterpillar.Examples;
using Caterpillar.Geometry;
using NUnit.Framework;

namespace Caterpillar.Tests.Examples;

[TestFixture]
public class ExampleModelTests
{
    public static IEnumerable<string> Names => ExampleModels.All.Select(m => m.Name);

    [TestCaseSource(nameof(Names))]
    public void The_generator_reproduces_the_bytes(string name)
    {
        var bytes = ExampleModels.ToStl(name, ExampleModels.All.Single(m => m.Name == name).Make());
        var kept = File.ReadAllBytes(PathOf(name));
        Assert.That(bytes.Length, Is.EqualTo(kept.Length));
        Assert.That(bytes.SequenceEqual(kept), "run: dotnet run --project examples/make");
        Assert.That(bytes, Has.Length.LessThan(1_500_000));
    }

    [TestCaseSource(nameof(Names))]
    public void Models_are_watertight_and_fit_on_the_bed(string name)
    {
        var read = MeshReader.Read(PathOf(name));
        Assert.That(read.Diagnostics, Is.Empty);
        var mesh = read.Value!.Single().Mesh;
        Assert.That((mesh.IsWatertight, mesh.BodyCount()), Is.EqualTo((true, 1)));
        Assert.That(mesh.Volume, Is.GreaterThan(1000));
        Assert.That(mesh.Bounds.Min.Z, Is.EqualTo(0));
        Assert.That(mesh.Bounds.Center.LengthXY, Is.LessThan(0.5));
        Assert.That(mesh.Bounds.Size.X, Is.InRange(40, 200));
        Assert.That(mesh.Bounds.Size.Y, Is.InRange(40, 200));
        Assert.That(mesh.Bounds.Size.Z, Is.InRange(10, 250));
    }

    [TestCase("vase.stl", 60, 1, 1)]
    [TestCase("vase.stl", 1, 1, 0)]
    [TestCase("bracket.stl", 3, 1, 2)]
    [TestCase("bracket.stl", 15, 1, 0)]
    [TestCase("bracket.stl", 37, 3, 0)]
    [TestCase("saddle_roof.stl", 10, 1, 0)]
    [TestCase("saddle_roof.stl", 17, 2, 0)]
    [TestCase("terrain.stl", 2, 1, 0)]
    public void Sections_have_their_contours(string name, double z, int outer, int holes)
    {
        var loops = MeshSections.At(TestData.Mesh(PathOf(name)), [z]).Value!.Single().Loops;
        Assert.That((loops.Count(l => l.SignedAreaXY > 0), loops.Count(l => l.SignedAreaXY < 0)), Is.EqualTo((outer, holes)));
    }

    [Test]
    public void Bracket_has_the_volume_of_its_plan()
    {
        // Foot, upright, rib; the holes are 48-gons.
        double Hole(double r) => 24 * r * r * Caterpillar.Basics.Angle.Sin(7.5);
        var volume = 60 * 40 * 6 + 6 * 40 * 44 + 6 * 200 - 2 * 6 * Hole(3) - 2 * 6 * Hole(2.5);
        Assert.That(TestData.Mesh(PathOf("bracket.stl")).Volume, Is.EqualTo(volume).Within(1e-3));
    }

    private static string PathOf(string name) => Path.Combine(TestData.Repository, "examples", "models", name);
}
