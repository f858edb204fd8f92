using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using Caterpillar.Basics;
using Caterpillar.Display;
using Caterpillar.Files;
using Caterpillar.Geometry;
using Caterpillar.Machines;
using Caterpillar.Planning;
using Caterpillar.Slicing;
using Caterpillar.Toolpaths;

namespace Caterpillar.Examples;

/// <summary>Images of the infill patterns, for the manual: a layer of a star-shaped part with a shaft, seen from above.</summary>
internal static class InfillImages
{
    private const double Height = 3;

    public static void Write(string folder)
    {
        var plain = new PrintSettings { TopLayers = 0, BottomLayers = 0, MinLayerTime = 0, FirstLayerSpeed = 0 };
        InfillPattern[] patterns =
        [
            InfillPattern.Lines, InfillPattern.Grid, InfillPattern.Triangles, InfillPattern.Cubic, InfillPattern.Gyroid, InfillPattern.Honeycomb,
            InfillPattern.Concentric, InfillPattern.Hilbert,
        ];
        foreach (var pattern in patterns) Draw(folder, pattern.ToString(), plain with { InfillPattern = pattern, InfillDensityPercent = 20 });
        const string Rings = "sin(180 * hypot(x - 110, y - 110) / spacing + 4 * z) - 0.3 * sin(6 * atan2(y - 110, x - 110))";
        Draw(folder, "Formula", plain with { InfillPattern = InfillPattern.Formula, InfillFormula = Rings, InfillDensityPercent = 20 });
        Draw(folder, "Solid", plain with { InfillDensityPercent = 100 });
        Draw(folder, "Monotonic", plain with { InfillPattern = InfillPattern.Monotonic, InfillDensityPercent = 20 });
        // Trees grow only below top surfaces.
        Draw(folder, "Lightning", plain with { InfillPattern = InfillPattern.Lightning, InfillDensityPercent = 20, TopLayers = 3 });
        Draw(folder, "Curves", plain with { InfillPattern = InfillPattern.Curves, InfillCurves = InfillPoint.Of(Spirals()) });
    }

    private static void Draw(string folder, string name, PrintSettings settings)
    {
        var sliced = PlanarSlicer.Slice([new NamedMesh(name, Star())], settings).Value ?? throw new InvalidOperationException(name);
        var layer = sliced.Layers[sliced.Layers.Count / 2];
        var plan = Planner.Plan(layer.Steps.Cast<Step>().ToArray(), new PrintSetup { Settings = settings });
        var toolpath = plan.Value ?? throw new InvalidOperationException(name);
        var bytes = PngWriter.ToBytes(ToolpathImage.Draw(toolpath, new ToolpathImageOptions { Width = 360, Height = 324, View = View.Top }));
        var file = "infill_" + name.ToLowerInvariant() + ".png";
        File.WriteAllBytes(Path.Combine(folder, file), bytes);
        Console.WriteLine($"{file}: {bytes.Length} bytes");
    }

    // Twelve spirals around the shaft, like user-drawn curves.
    private static IEnumerable<Polyline> Spirals() => Enumerable.Range(0, 12).Select(k => new Polyline(Enumerable.Range(0, 45).Select(i =>
    {
        var (sin, cos) = Angle.SinCos(30.0 * k + 2 * i);
        return new Vec3(110 + (4 + 0.3 * i) * cos, 110 + (4 + 0.3 * i) * sin);
    }).ToArray()));

    // A star around a shaft, in the middle of the bed.
    private static TriMesh Star()
    {
        const int Corners = 180;
        var points = new List<Vec3>();
        var triangles = new List<int>();
        foreach (var z in new[] { 0, Height })
        {
            for (var i = 0; i < Corners; i++)
            {
                var (sin, cos) = Angle.SinCos(360.0 * i / Corners);
                var radius = 16 + 3 * Angle.SinCos(5 * 360.0 * i / Corners).Sin;
                points.Add(new Vec3(110 + radius * cos, 110 + radius * sin, z));
                points.Add(new Vec3(110 + 5 * cos, 110 + 5 * sin, z));
            }
        }
        for (var i = 0; i < Corners; i++)
        {
            // Outside and inside, below and above.
            int a = 2 * i, b = 2 * ((i + 1) % Corners), top = 2 * Corners;
            Quad(a, b, b + top, a + top);
            Quad(b + 1, a + 1, a + 1 + top, b + 1 + top);
            Quad(a + 1, b + 1, b, a);
            Quad(a + top, b + top, b + 1 + top, a + 1 + top);
        }
        return TriMesh.Create(points, triangles);

        void Quad(int a, int b, int c, int d) => triangles.AddRange([a, b, c, a, c, d]);
    }
}
