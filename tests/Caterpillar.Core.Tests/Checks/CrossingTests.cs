using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using Caterpillar.GCode;
using Caterpillar.Geometry;
using Caterpillar.Machines;
using Caterpillar.Planning;
using Caterpillar.Slicing;
using Caterpillar.Toolpaths;
using NetTopologySuite.Geometries;
using NetTopologySuite.Geometries.Prepared;
using NUnit.Framework;

namespace Caterpillar.Tests.Checks;

/// <summary>What the written file does, judged by NetTopologySuite: extrusions stay in the section of their layer, and what leaves it is retracted.</summary>
public class CrossingTests
{
    // mm that rounding and the simplifying of outlines may take.
    private const double Rounding = 0.03;

    private static readonly GeometryFactory Factory = new();

    private static IEnumerable<TestCaseData> Cases() => new[] { "plate_holes.stl", "tube_thin.stl", "torus.obj", "nested_boxes.obj" }
        .SelectMany((name, i) => Rounds.InTurn([true, false], i, 1).Select(infill => new TestCaseData(name, infill)));

    [TestCaseSource(nameof(Cases))]
    public void No_extrusion_crosses_a_hole_and_no_travel_a_wall_without_retraction(string name, bool infill)
    {
        var mesh = TestData.Mesh(TestData.Shared("meshes/" + name)).Scaled(0.6).Moved(new Vec3(110, 110));
        var setup = new PrintSetup
        {
            Settings = new PrintSettings
            {
                SkirtLoops = 0, RetractionMinTravel = 0, InfillDensityPercent = infill ? 20 : 0, LayerHeight = 0.4, FirstLayerHeight = 0.4, LineWidth = 0.5,
            },
        };
        var sliced = PlanarSlicer.Slice([new NamedMesh(name, mesh)], setup.Settings).Value!;
        var plan = Planner.Plan(sliced.Layers.SelectMany(l => l.Steps).ToArray(), setup).Value!;
        using var memory = new MemoryStream();
        new GCodeWriter(plan, SetupFormat.Of(setup, plan).Value).WriteAll(memory);
        var decoded = GCodeDecoder.Decode(GCodeDocument.FromBytes(memory.ToArray(), name)).Value!.Toolpath;
        var heights = sliced.Layers.Select(l => l.Layer.Z).ToArray();
        var sections = MeshSections.At(mesh, heights.Select(z => z - 0.2).ToArray()).Value!;
        var parts = heights.Zip(sections, (z, s) => (z, s)).ToDictionary(p => (int)Math.Round(p.z * 1000), p => PreparedGeometryFactory.Prepare(Part(p.s)));
        // Nothing oozes before the first extrusion.
        var (retracted, extrusions, travels) = (true, 0.0, 0.0);
        foreach (var move in decoded.Moves())
        {
            if (move.Kind is MoveKind.Retract or MoveKind.Wipe) retracted = true;
            if (move.Kind is MoveKind.Deretract or MoveKind.MovingDeretract or MoveKind.Print) retracted = false;
            if (move.Length < 0.01 || (move.Kind == MoveKind.Travel ? retracted : move.Kind != MoveKind.Print)) continue;
            if (move.Start.Z != move.End.Z || !parts.TryGetValue((int)Math.Round(move.End.Z * 1000), out var part)) continue;
            var outside = Outside(part, move);
            if (move.Kind == MoveKind.Print) extrusions += move.Length;
            else travels += move.Length;
            Assert.That(outside, Is.LessThan(0.1), () => $"{move.Kind} {move.Role} from {move.Start} to {move.End}");
        }
        Assert.That(extrusions, Is.GreaterThan(1000), "judged");
        TestContext.Out.WriteLine($"{name}: {extrusions:F0} mm of extrusions, {travels:F0} mm of travels without retraction");
    }

    private static double Outside(IPreparedGeometry part, Move move)
    {
        var line = Factory.CreateLineString([new Coordinate(move.Start.X, move.Start.Y), new Coordinate(move.End.X, move.End.Y)]);
        return part.Contains(line) ? 0 : line.Difference(part.Geometry).Length;
    }

    // Even-odd: the meshes have no contours that cross.
    private static NetTopologySuite.Geometries.Geometry Part(Section section)
    {
        NetTopologySuite.Geometries.Geometry part = Factory.CreatePolygon();
        foreach (var loop in section.Loops)
        {
            var ring = loop.Points.Append(loop[0]).Select(p => new Coordinate(p.X, p.Y)).ToArray();
            part = part.SymmetricDifference(Factory.CreatePolygon(ring).Buffer(0));
        }
        return part.Buffer(Rounding);
    }
}
