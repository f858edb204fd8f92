using System;
using System.Collections.Generic;
using System.Linq;
using Caterpillar.Geometry;
using Caterpillar.Machines;
using Caterpillar.Slicing;
using Caterpillar.Toolpaths;
using NUnit.Framework;

namespace Caterpillar.Tests.Slicing;

/// <summary>Supports are easy to remove because their beads never touch those of the part: judged by drawing all beads on a grid of pixels.</summary>
public class SupportGapTests
{
    private const double Pixel = 0.1;
    private const double LayerHeight = 0.4;

    // mm: half a pixel's diagonal for each of both beads.
    private const double Drawn = 0.15;

    private static readonly string[] Meshes =
        ["cheburashka.ply", "homer.stl", "nested_boxes.obj", "ogre_bodies.ply", "plate_holes.stl", "spot.obj", "torus.obj"];

    private static bool IsSupport(PathStep step) => step.Path.Role is Role.Support or Role.SupportInterface;

    private static IEnumerable<TestCaseData> Cases() => Meshes
        .SelectMany((mesh, i) => Rounds.InTurn([SupportKind.Grid, SupportKind.Tree], i, 1).Select(kind => new TestCaseData(mesh, kind)));

    [TestCaseSource(nameof(Cases))]
    public void Beads_of_supports_keep_away_from_those_of_the_part(string mesh, SupportKind kind)
    {
        var settings = new PrintSettings
        {
            LineWidth = 0.4, BeadShape = BeadShape.Rectangle, LayerHeight = LayerHeight, FirstLayerHeight = LayerHeight, TopLayers = 0, BottomLayers = 0,
            InfillDensityPercent = 0, WallCount = 1, MinLayerTime = 0, SkirtLoops = 0, Support = kind, SupportTopGap = LayerHeight,
                SupportBottomGap = LayerHeight, MaxBridgeLength = 0, SupportRemoveSmallOverhang = false,
        };
        var model = TestData.Mesh(TestData.Shared("meshes/" + mesh));
        if (mesh is "cheburashka.ply" or "homer.stl" or "spot.obj") model = model.Scaled(0.5);
        var layers = Solids.Slice(settings, model);
        Beads Part(int i) => new(model.Bounds, i < layers.Count ? layers[i].Steps.Where(s => !IsSupport(s)).Select(s => s.Path) : []);
        Beads? below = null;
        var (part, above) = (Part(0), Part(1));
        for (var i = 0; i < layers.Count; i++, (below, part, above) = (part, above, Part(i + 1)))
        {
            foreach (var path in layers[i].Steps.Where(IsSupport).Select(s => s.Path))
            {
                var place = $"{path.Role} at {layers[i].Layer.Z}";
                // Ends of single extrusions are round, and reach out by half their width.
                var gap = settings.SupportXyGap - Drawn - (path.IsClosed ? 0 : settings.LineWidth / 2);
                Assert.That(part.IsTouchedBy(path, gap), Is.False, $"beside the part: {place}");
                // Corners of loops may reach a tenth of a millimeter below an edge.
                var shrunk = -Drawn - (path.IsClosed ? 0.1 : settings.LineWidth / 2);
                Assert.That(above.IsTouchedBy(path, shrunk), Is.False, $"below the part: {place}");
                Assert.That(below?.IsTouchedBy(path, shrunk) ?? false, Is.False, $"on the part: {place}");
            }
        }
        Assert.That(layers.Any(l => l.Steps.Any(IsSupport)), "there are supports");
    }

    /// <summary>The pixels that beads cover.</summary>
    private sealed class Beads
    {
        private readonly Vec3 _origin;
        private readonly int _width;
        private readonly int _height;
        private readonly bool[] _covered;

        public Beads(Bounds bounds, IEnumerable<PrintPath> paths)
        {
            _origin = bounds.Min;
            _width = (int)(bounds.Size.X / Pixel) + 1;
            _height = (int)(bounds.Size.Y / Pixel) + 1;
            _covered = new bool[_width * _height];
            foreach (var path in paths) Draw(path, 0, true);
        }

        /// <summary>Whether a path, whose beads are wider by a gap on each side, covers a pixel of these.</summary>
        public bool IsTouchedBy(PrintPath path, double gap) => Draw(path, gap, false);

        private bool Draw(PrintPath path, double gap, bool cover)
        {
            for (var i = 0; i < path.SegmentCount; i++)
            {
                Vec3 a = (path.Points[i] - _origin).WithZ(0), b = (path.EndOf(i) - _origin).WithZ(0);
                var reach = path.BeadOf(i).Area / LayerHeight / 2 + gap;
                int Low(double v) => Math.Max(0, (int)Math.Floor((v - reach) / Pixel));
                int High(double v, int count) => Math.Min(count - 1, (int)((v + reach) / Pixel));
                int toX = High(Math.Max(a.X, b.X), _width), toY = High(Math.Max(a.Y, b.Y), _height);
                for (var y = Low(Math.Min(a.Y, b.Y)); y <= toY; y++)
                {
                    for (var x = Low(Math.Min(a.X, b.X)); x <= toX; x++)
                    {
                        if (!cover && !_covered[y * _width + x]) continue;
                        if (Distance(new Vec3((x + 0.5) * Pixel, (y + 0.5) * Pixel), a, b) > reach) continue;
                        if (!cover) return true;
                        _covered[y * _width + x] = true;
                    }
                }
            }
            return false;
        }

        private static double Distance(Vec3 p, Vec3 a, Vec3 b)
        {
            var square = (b - a).LengthSquared;
            var t = square > 0 ? Math.Max(0, Math.Min(1, ((p.X - a.X) * (b.X - a.X) + (p.Y - a.Y) * (b.Y - a.Y)) / square)) : 0;
            return p.DistanceTo(Vec3.Lerp(a, b, t));
        }
    }
}
