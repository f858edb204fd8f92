using System;
using System.Collections.Generic;
using System.Linq;
using Caterpillar.Basics;
using Caterpillar.Checks;
using Caterpillar.GCode;
using Caterpillar.Geometry;
using Caterpillar.Machines;
using Caterpillar.Planning;
using Caterpillar.Slicing;
using Caterpillar.Toolpaths;
using NUnit.Framework;

namespace Caterpillar.Tests.EndToEnd;

/// <summary>Mesh → steps → toolpath → G-code → toolpath: the result is what was planned.</summary>
public class RoundTripTests
{
    private static readonly string[] Closed =
        ["fandisk.stl", "spot.obj", "cheburashka.ply", "homer.stl", "plate_holes.stl", "torus.obj", "nested_boxes.obj", "overlap_boxes.stl", "tube_thin.stl",
            "igea.ply"];

    private static IEnumerable<TestCaseData> Cases()
    {
        var library = new ProfileLibrary();
        var profiles = library.Names<Printer>().Where(name => library.Printer(name).Value!.ExtrusionUnit != ExtrusionUnit.None).ToArray();
        // Every profile sees a model with islands and holes; Mono is slow, so the large ones stay with the generic printer.
        var prints = Closed.Select(mesh => (Mesh: mesh, Profile: "generic"))
            .Concat(profiles.Where(p => p != "generic").SelectMany(p => new[] { (Mesh: "plate_holes.stl", Profile: p), (Mesh: "torus.obj", Profile: p) }));
        ExtrusionMode[] modes = [ExtrusionMode.Relative, ExtrusionMode.Absolute];
        return prints.SelectMany((print, i) => Rounds.InTurn(modes, i, 1).Select(mode => new TestCaseData(print.Mesh, print.Profile, mode)));
    }

    [TestCaseSource(nameof(Cases))]
    [Category("Arithmetic")]
    public void What_is_written_is_what_was_planned(string mesh, string profile, ExtrusionMode mode)
    {
        var setup = Setup(profile, mode);
        var planned = Plan(mesh, setup);
        var written = SafeWriter.ToDocument(planned, setup);
        Assert.That(written.Diagnostics.Where(d => d.Severity == Severity.Error), Is.Empty);
        var decoded = GCodeDecoder.Decode(written.Value!,
            new DecodeOptions { Flavor = setup.Printer.Flavor, FilamentDiameter = setup.Material.FilamentDiameter }).Value!.Toolpath;

        var decimals = setup.Printer.DecimalsXyz;
        var before = Sums.Of(planned);
        // Purge lines of the start code come before the first layer.
        var after = Sums.Of(decoded, onlyLayers: true);
        var step = NumberFormatter.FromUnits(1, decimals);
        Assert.That(after.Moves, Is.InRange(before.Moves * 99 / 100, before.Moves), "moves shorter than the printed decimals may vanish");
        Assert.That(after.Length, Is.EqualTo(before.Length).Within(step * before.Moves / 2), "each end is off by at most half a step");
        Assert.That(after.Length, Is.EqualTo(Sums.Of(planned, decimals: decimals).Length).Within(1e-6), "and by nothing else");
        Assert.That(after.Deposited, Is.EqualTo(before.Deposited).Within(1e-4));
        Assert.That(after.Box.Min.DistanceTo(before.Box.Min), Is.LessThan(step));
        Assert.That(after.Box.Max.DistanceTo(before.Box.Max), Is.LessThan(step));
        Assert.That(after.WorstDrift(before), Is.LessThan(1e-4), "E does not drift along the file");
    }

    /// <summary>Every closed mesh with every profile that extrudes, in both modes: a minute on .NET, so only on request.</summary>
    [Test, Explicit]
    public void What_is_written_is_what_was_planned_for_all_meshes_and_profiles()
    {
        var library = new ProfileLibrary();
        var runs = 0;
        foreach (var mesh in Closed)
        {
            foreach (var profile in library.Names<Printer>().Where(name => library.Printer(name).Value!.ExtrusionUnit != ExtrusionUnit.None))
            {
                foreach (var mode in new[] { ExtrusionMode.Relative, ExtrusionMode.Absolute })
                {
                    try
                    {
                        What_is_written_is_what_was_planned(mesh, profile, mode);
                        runs++;
                    }
                    catch (IgnoreException tooThin)
                    {
                        TestContext.Out.WriteLine($"{mesh} with {profile}: {tooThin.Message}");
                    }
                }
            }
        }
        TestContext.Out.WriteLine($"{runs} round trips");
    }

    [TestCase("beetle_open.obj")]
    [TestCase("ogre_bodies.ply")]
    [TestCase("bowl_open.ply")]
    [Category("Arithmetic")]
    public void Open_meshes_give_diagnostics_and_what_can_be_printed_comes_back(string mesh)
    {
        var setup = Setup("generic", ExtrusionMode.Relative);
        var sliced = PlanarSlicer.Slice(ModelPlacement.OnBed(Small(mesh, setup), setup.Printer.BuildBounds.Center), setup.Settings);
        Assert.That(sliced.Diagnostics, Is.Not.Empty);
        if (sliced.Value is null) return;
        var planned = Planner.Plan(sliced.Value.ToSteps(), setup).Value!;
        var decoded = GCodeDecoder.Decode(SafeWriter.ToDocument(planned, setup).Value!).Value!.Toolpath;
        Assert.That(Sums.Of(decoded, onlyLayers: true).Deposited, Is.EqualTo(Sums.Of(planned).Deposited).Within(1e-4));
    }

    private static PrintSetup Setup(string profile, ExtrusionMode mode)
    {
        var setup = new ProfileLibrary().Setup(profile).Value!;
        // Coarse layers keep the test fast; they are as high as the nozzle allows.
        var height = Math.Min(setup.Settings.LineWidth, setup.Printer.NozzleDiameter) * 0.9;
        return setup with
        {
            Printer = setup.Printer with { ExtrusionMode = mode, MaxFlow = 0 },
            Material = setup.Material with { MaxFlow = 0 },
            Settings = setup.Settings with { LayerHeight = height, FirstLayerHeight = height },
        };
    }

    // At most 40 nozzles high and 80 wide, as few layers are as good as more.
    private static NamedMesh[] Small(string mesh, PrintSetup setup)
    {
        var models = MeshReader.Read(TestData.Shared("meshes/" + mesh)).Value!;
        var size = models.Aggregate(Bounds.Empty, (box, m) => box.Include(m.Mesh.Bounds)).Size;
        var scale = Math.Min(1, setup.Printer.NozzleDiameter * Math.Min(40 / size.Z, 80 / Math.Max(size.X, size.Y)));
        return models.Select(m => new NamedMesh(m.Name, m.Mesh.Scaled(scale))).ToArray();
    }

    private static Toolpath Plan(string mesh, PrintSetup setup)
    {
        var sliced = PlanarSlicer.Slice(ModelPlacement.OnBed(Small(mesh, setup), setup.Printer.BuildBounds.Center), setup.Settings);
        if (sliced.Value is null) Assert.Ignore($"{mesh} is too thin for a nozzle of {setup.Printer.NozzleDiameter} mm.");
        var planned = Planner.Plan(sliced.Value!.ToSteps(), setup);
        Assert.That(planned.Diagnostics.Where(d => d.Severity == Severity.Error), Is.Empty);
        return planned.Value!;
    }

    private sealed record Sums(int Moves, double Length, double Deposited, Bounds Box, IReadOnlyList<(double Z, double E)> Running)
    {
        public static Sums Of(Toolpath toolpath, bool onlyLayers = false, int? decimals = null)
        {
            var moves = 0;
            double length = 0, deposited = 0;
            var box = Bounds.Empty;
            var running = new List<(double Z, double E)>();
            foreach (var move in toolpath.Moves())
            {
                if (onlyLayers && move.Layer < 0) continue;
                // A printing move too short for the decimals is written, and read, as material in place.
                deposited += move.Deposited;
                if (move.Kind != MoveKind.Print) continue;
                moves++;
                length += decimals is { } d ? Printed(move.Start, d).DistanceTo(Printed(move.End, d)) : move.Length;
                box = box.Include(move.Start).Include(move.End);
                // The last entry of each height is the sum of E when the layer was done.
                if (running.Count == 0 || Math.Abs(running[running.Count - 1].Z - move.End.Z) > 1e-3) running.Add((move.End.Z, deposited));
                else running[running.Count - 1] = (move.End.Z, deposited);
            }
            return new Sums(moves, length, deposited, box, running);
        }

        private static Vec3 Printed(Vec3 p, int decimals) => new(Printed(p.X, decimals), Printed(p.Y, decimals), Printed(p.Z, decimals));

        private static double Printed(double value, int decimals) => NumberFormatter.FromUnits(NumberFormatter.ToUnits(value, decimals), decimals);

        public double WorstDrift(Sums other)
        {
            Assert.That(Running.Count, Is.EqualTo(other.Running.Count), "as many layers");
            return Running.Zip(other.Running, (a, b) => Math.Abs(a.E - b.E)).Max();
        }
    }
}
