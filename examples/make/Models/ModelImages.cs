using System;
using System.IO;
using Caterpillar.Checks;
using Caterpillar.Display;
using Caterpillar.Files;
using Caterpillar.GCode;
using Caterpillar.Geometry;
using Caterpillar.Machines;
using Caterpillar.Planning;
using Caterpillar.Shaping;
using Caterpillar.Slicing;
using Caterpillar.Toolpaths;

namespace Caterpillar.Examples;

/// <summary>Images of the printed example models, for the manual.</summary>
internal static class ModelImages
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
            var name = Path.GetFileNameWithoutExtension(model);
            // Cut at two thirds of the height, so that walls and infill are visible.
            Write(toolpath, toolpath.Layers.Count * 2 / 3, Path.Combine(folder, name + ".png"));
            if (name == "bracket") Write(Twisted(toolpath, setup), toolpath.Layers.Count, Path.Combine(folder, "bracket_twisted.png"));
        }
    }

    // As in the manual: the G-code is read back and deformed.
    private static Toolpath Twisted(Toolpath toolpath, PrintSetup setup)
    {
        var gcode = SafeWriter.ToDocument(toolpath, setup).Value ?? throw new InvalidOperationException("The bracket cannot be printed.");
        var decoded = GCodeDecoder.Decode(gcode).Value ?? throw new InvalidDataException("The bracket cannot be read.");
        var middle = ToolpathTotals.Of(decoded.Toolpath).PrintBounds.Center;
        var twist = DeformationText.Compile("r, theta + 1.2 * z, z", system: DeformationSystem.Cylindrical, axis: middle).Value!;
        return decoded.Toolpath.Deform(new MoveFilter { FirstLayer = 0 }, twist).Value!;
    }

    private static void Write(Toolpath toolpath, int layers, string file)
    {
        var options = new ToolpathImageOptions { Width = 800, Height = 600, View = new View(-60, 35), Filter = new MoveFilter { LastLayer = layers } };
        var bytes = PngWriter.ToBytes(ToolpathImage.Draw(toolpath, options));
        File.WriteAllBytes(file, bytes);
        Console.WriteLine($"{Path.GetFileName(file)}: {bytes.Length} bytes");
    }
}
