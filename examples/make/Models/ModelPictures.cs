using System;
using System.IO;
using Caterpillar.Display;
using Caterpillar.Geometry;
using Caterpillar.Machines;
using Caterpillar.Planning;
using Caterpillar.Slicing;

namespace Caterpillar.Examples;

/// <summary>Pictures of the example models as they are printed, for the manual.</summary>
internal static class ModelPictures
{
    public static void Write(string models, string folder)
    {
        Directory.CreateDirectory(folder);
        foreach (var model in Directory.GetFiles(models, "*.stl"))
        {
            var setup = new ProfileLibrary().Setup().Value ?? throw new InvalidOperationException("The generic printer is missing.");
            var meshes = ModelPlacement.OnBed(MeshReader.Read(model).Value ?? throw new InvalidDataException(model), setup.Printer.BuildBounds.Center);
            var sliced = PlanarSlicer.Slice(meshes, setup.Settings).Value ?? throw new InvalidDataException(model);
            var toolpath = Planner.Plan(sliced.ToSteps(), setup).Value ?? throw new InvalidDataException(model);
            // Cut open in the upper third, so that walls and infill show.
            var options = new PictureOptions { Width = 800, Height = 600, View = new View(-60, 35), Layers = (0, toolpath.Layers.Count * 2 / 3) };
            var bytes = PngWriter.ToBytes(Picture.Draw(toolpath, options));
            var name = Path.GetFileNameWithoutExtension(model) + ".png";
            File.WriteAllBytes(Path.Combine(folder, name), bytes);
            Console.WriteLine($"{name}: {bytes.Length} bytes");
        }
    }
}
