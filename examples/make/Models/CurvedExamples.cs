using System;
using System.Collections.Generic;
using System.Linq;
using Caterpillar.Basics;
using Caterpillar.Checks;
using Caterpillar.Curved;
using Caterpillar.Display;
using Caterpillar.Geometry;
using Caterpillar.Jobs;
using Caterpillar.Machines;
using Caterpillar.Planning;
using Caterpillar.Slicing;
using Caterpillar.Tests.Geometry.Meshes;
using Caterpillar.Toolpaths;

namespace Caterpillar.Examples;

/// <summary>Examples of curved printing. All toolpaths passed the checks of the writer. Settings are coarse, so that images show the extrusions.</summary>
internal static class CurvedExamples
{
    private static readonly Vec3 Middle = new(110, 110);

    private static readonly PrintSetup Plain = new()
    {
        Printer = new Printer { NozzleDiameter = 0.8 },
        Settings = new PrintSettings
        {
            LayerHeight = 0.6, FirstLayerHeight = 0.6, LineWidth = 0.8, MinLayerTime = 0, FirstLayerSpeed = 0, CurvedMaxGap = 0.8, SkirtLoops = 0,
        },
    };

    /// <summary>Their names, generators, colors and views.</summary>
    public static IReadOnlyList<(string Name, Func<CurvedExample> Make, ColorBy Color, View View)> All { get; } =
    [
        ("roof", Roof, ColorBy.Role, new View(-60, 22)),
        ("between", Between, ColorBy.Layer, new View(-60, 22)),
        ("terrain", TerrainPattern, ColorBy.Role, new View(-70, 40)),
        ("branching", Branches, ColorBy.Layer, new View(-60, 14)),
        ("overhang", Overhang, ColorBy.Layer, new View(-60, -12)),
        ("steps", () => Mound(smooth: false), ColorBy.Role, new View(-60, 35)),
        ("smooth", () => Mound(smooth: true), ColorBy.Role, new View(-60, 35)),
        ("surface", Surface, ColorBy.Layer, new View(-60, 30)),
        ("vase", VaseOnSaddle, ColorBy.Layer, new View(-50, 16)),
    ];

    /// <summary>A flat bottom, and layers parallel to a saddle at the top.</summary>
    public static CurvedExample Roof()
    {
        var part = SaddleRoof.Make().Moved(Middle);
        return Sliced(part, LayerField.Vertical(PlanSurface.Of(part), new LayerBlend(2, 18)), Plain);
    }

    /// <summary>The same number of layers everywhere between the bed and the saddle.</summary>
    public static CurvedExample Between()
    {
        var part = SaddleRoof.Make().Moved(Middle);
        return Sliced(part, LayerField.Between(PlanSurface.Level(0), PlanSurface.Of(part)), Plain);
    }

    /// <summary>Flat wavy rings, printed onto terrain.</summary>
    public static CurvedExample TerrainPattern()
    {
        var land = Terrain.Make();
        // Hills that the head can go around.
        var terrain = TriMesh.Create(land.Vertices.Select(p => p.WithZ(0.25 * p.Z) + Middle).ToList(), land.Indices);
        var bead = new Bead(0.8 * 0.5, 0.5);
        var steps = new List<Step>();
        for (var radius = 6; radius <= 38; radius += 4)
        {
            var petals = Enumerable.Range(0, 180).Select(i =>
            {
                var (sin, cos) = Angle.SinCos(2.0 * i);
                var r = radius * (1 + 0.12 * Angle.Cos(12.0 * i));
                return Middle + new Vec3(r * cos, r * sin, 0.5);
            });
            steps.Add(new PathStep(new PrintPath(petals.ToList(), bead, closed: true)));
        }
        var projected = SurfaceProjection.Project(steps, PlanSurface.Of(terrain), Steep(60), squeeze: 0.05).OrThrow();
        return Checked(projected, Steep(60), terrain);
    }

    /// <summary>Layers that change evenly from the bottom of a trunk to the ends of its branches.</summary>
    public static CurvedExample Branches()
    {
        var part = Welded(Branching.Make()).Moved(Middle);
        var setup = Plain with { Settings =
            Plain.Settings with { LayerHeight = 0.8, FirstLayerHeight = 0.8, LineWidth = 1, CurvedMaxGap = 1.2, InfillDensityPercent = 10 } };
        return Sliced(part, LayerField.Harmonic(MeshBoundaries.Find(part).OrThrow()), setup);
    }

    /// <summary>A hat with a brim that overhangs by 70 degrees, in layers supported by the layers before them.</summary>
    public static CurvedExample Overhang()
    {
        var hat = SlicingImages.Revolved((4, 0), (4, 6), (20, 12), (20, 14)).Moved(Middle);
        // Thick layers would overhang by more than half a line width.
        var setup = Plain with { Settings = Plain.Settings with { LayerHeight = 0.25, FirstLayerHeight = 0.25 } };
        return Sliced(hat, LayerField.Vertical(PlanSurface.AgainstOverhangs([new NamedMesh("hat", hat)], setup).OrThrow()), setup);
    }

    /// <summary>A mound with gentle slopes, in level layers or in such that bend until its top has no steps.</summary>
    public static CurvedExample Mound(bool smooth)
    {
        var plan = new Bounds(Middle - new Vec3(16, 12), Middle + new Vec3(16, 12));
        var part = CurvedPlate.Make(plan, (_, _) => 0, (x, y) => 7 + 2.5 * Angle.Cos(5 * (x - 110)) * Angle.Cos(7 * (y - 110)));
        return Sliced(part, smooth ? LayerField.Smooth([new NamedMesh("part", part)], Plain).OrThrow() : LayerField.Vertical(PlanSurface.Level(0)), Plain);
    }

    /// <summary>A vase of one spiral extrusion on a saddle.</summary>
    public static CurvedExample VaseOnSaddle()
    {
        static double Saddle(double x, double y) => 5 + ((x - 110) * (x - 110) - (y - 110) * (y - 110)) / 90;
        var vase = SlicingImages.Revolved((2, 0), (5, 0), (8, 0), (11, 0), (14, 0), (16, 0), (18, 6), (20, 12), (17, 19), (14, 26), (16, 31),
            (18, 36), (15, 36), (12, 36), (9, 36), (6, 36), (3, 36)).Moved(Middle);
        var bent = TriMesh.Create(vase.Vertices.Select(p => p.WithZ(p.Z + Saddle(p.X, p.Y))).ToList(), vase.Indices);
        var surface = PlanSurface.Of(Saddle, 3);
        var setup = Plain with { Settings = Plain.Settings with { SpiralVase = true, BottomLayers = 1 } };
        var plan = new Bounds(Middle - new Vec3(24, 24), Middle + new Vec3(24, 24));
        return Sliced(bent, LayerField.Vertical(surface), setup, new CurvedOptions { Onto = surface }, CurvedPlate.Make(plan, (_, _) => 0, Saddle));
    }

    /// <summary>A lobed surface whose rim turns over, as single walls along it, by a head that leans.</summary>
    public static CurvedExample Surface()
    {
        const int Rings = 60, Around = 90;
        var points = new List<Vec3>();
        var corners = new List<int>();
        for (var ring = 0; ring <= Rings; ring++)
        {
            // A stem, then an arc that turns outward.
            var length = 60.0 * ring / Rings;
            var turn = Math.Max(0, length - 32) * 4.3;
            var (radius, z) = (22 - 14 * Angle.Cos(turn), Math.Min(length, 32) + 14 * Angle.Sin(turn));
            for (var k = 0; k < Around; k++)
            {
                var angle = 360.0 * k / Around;
                var r = radius * (1 + 0.12 * ring / Rings * Angle.Cos(6 * angle));
                points.Add(Middle + new Vec3(r * Angle.Cos(angle), r * Angle.Sin(angle), z));
                if (ring == Rings) continue;
                int a = ring * Around + k, b = ring * Around + (k + 1) % Around;
                corners.AddRange([a, b, b + Around, a, b + Around, a + Around]);
            }
        }
        var shell = new NamedMesh("shell", TriMesh.Create(points, corners));
        var setup = Plain with
        {
            Printer = Plain.Printer with
            {
                RotaryAxes = new([RotaryAxis.Parse("C head z speed 120")!, RotaryAxis.Parse("B head y at 0 0 60 from -110 to 110 speed 90")!]),
                HeadOutline = new([new HeadPoint(0.8, 0), new HeadPoint(3, 8), new HeadPoint(4, 30), new HeadPoint(12, 50)]),
            },
            Settings = Plain.Settings with { OpenContours = OpenContours.Surface, BrimWidth = 5 },
        };
        using var job = PrintJob.Slice([new SliceModel(shell, setup.Settings)], LayerField.Harmonic(MeshBoundaries.Find(shell.Mesh).OrThrow()), setup,
            new PrintJobOptions { Tilt = new ToolAim() }).OrThrow();
        SafeWriter.ToDocument(job.Toolpath, job.Setup).OrThrow();
        return new CurvedExample(job.Toolpath, job.Setup);
    }

    private static PrintSetup Steep(double degrees) => Plain with { Settings = Plain.Settings with { CurvedMaxSlope = degrees } };

    private static CurvedExample Sliced(TriMesh part, LayerField field, PrintSetup setup, CurvedOptions? options = null, TriMesh? under = null)
        => Checked(CurvedSlicer.Slice([new NamedMesh("part", part)], field, setup, options).OrThrow().ToSteps(), setup, under);

    // A print that the writer refuses is not an example.
    private static CurvedExample Checked(IReadOnlyList<Step> steps, PrintSetup setup, TriMesh? under)
    {
        var over = setup with { Settings = setup.Settings with { ZHopType = ZHopType.AbovePath }, PrintedOn = under };
        var toolpath = Planner.Plan(steps, over).OrThrow();
        SafeWriter.ToDocument(toolpath, over).OrThrow();
        return new CurvedExample(toolpath, over);
    }

    private static TriMesh Welded(TriMesh mesh) => MeshReader.Read(StlWriter.ToBytes(mesh, "mesh"), "mesh.stl").OrThrow()[0].Mesh;
}

/// <summary>A curved print that passed the checks.</summary>
/// <param name="Toolpath">Its toolpath.</param>
/// <param name="Setup">Its print setup.</param>
internal sealed record CurvedExample(Toolpath Toolpath, PrintSetup Setup);
