using System;
using System.IO;
using System.Linq;
using Caterpillar.Basics;
using Caterpillar.Display;
using Caterpillar.Files;
using Caterpillar.Geometry;
using Caterpillar.Machines;
using Caterpillar.Planning;
using Caterpillar.Slicing;

namespace Caterpillar.Examples;

/// <summary>Pictures of curved slicing, for the manual.</summary>
internal static class CurvedPictures
{
    public static void Write(string folder)
    {
        var plain = new PrintSettings { LayerHeight = 0.6, FirstLayerHeight = 0.6, LineWidth = 0.8, MinLayerTime = 0, FirstLayerSpeed = 0, CurvedMaxGap = 0.7 };
        var roof = SaddleRoof.Make().Moved(new Vec3(100, 100));
        var plan = PlanSurface.Of(roof);
        Draw(folder, "roof", roof, LayerField.Vertical(plan, new LayerBlend(2, 18)), plain, ColorBy.Role);
        Draw(folder, "between", roof, LayerField.Between(PlanSurface.Level(0), plan), plain, ColorBy.Layer);
        var hat = SlicingPictures.Revolved((4, 0), (4, 6), (20, 12), (20, 14)).Moved(new Vec3(100, 100));
        var setup = new PrintSetup { Settings = plain };
        var overhangs = PlanSurface.AgainstOverhangs([new NamedMesh("hat", hat)], setup).OrThrow();
        Draw(folder, "overhang", hat, LayerField.Vertical(overhangs), plain, ColorBy.Layer, new View(-60, -12));
    }

    private static void Draw(string folder, string name, TriMesh mesh, LayerField field, PrintSettings settings, ColorBy color, View? view = null)
    {
        var setup = new PrintSetup { Settings = settings };
        var sliced = CurvedSlicer.Slice([new NamedMesh(name, mesh)], field, setup).OrThrow();
        var toolpath = Planner.Plan(sliced.ToSteps(), setup).OrThrow();
        var options = new PictureOptions { Width = 480, Height = 360, View = view ?? new View(-60, 22), ColorBy = color };
        var bytes = PngWriter.ToBytes(Picture.Draw(toolpath, options));
        File.WriteAllBytes(Path.Combine(folder, "curved_" + name + ".png"), bytes);
        Console.WriteLine($"curved_{name}.png: {bytes.Length} bytes");
    }
}
