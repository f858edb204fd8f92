using System;
using System.IO;

namespace Caterpillar.Examples;

/// <summary>
/// Writes the example models: <c>dotnet run --project examples/make [FOLDER]</c>. The default folder is examples/models of the repository. With <c>--images
/// FOLDER</c> it draws the examples instead. With <c>--curved</c> it slices, checks and simulates the curved examples.
/// </summary>
internal static class Program
{
    private static int Main(string[] arguments)
    {
        if (arguments.Length == 2 && arguments[0] == "--images")
        {
            Legends.Write(arguments[1]);
            TraceImages.Write(arguments[1]);
            SlicingImages.Write(arguments[1]);
            SeamImages.Write(arguments[1]);
            InfillImages.Write(arguments[1]);
            CurvedImages.Write(arguments[1]);
            if (ModelsFolder() is not { } models) return 0;
            ModelImages.Write(models, arguments[1]);
            TurtleImages.Write(Path.Combine(models, "..", "turtle"), arguments[1]);
            return 0;
        }
        if (arguments is ["--curved"]) return CurvedReport.WriteAll(Console.Out) ? 0 : 1;
        var folder = arguments.Length > 0 ? arguments[0] : ModelsFolder();
        if (folder is null)
        {
            Console.Error.WriteLine("This program is not inside the repository. Give a folder.");
            return 2;
        }
        Directory.CreateDirectory(folder);
        foreach (var (name, make) in ExampleModels.All)
        {
            var bytes = ExampleModels.ToStl(name, make());
            File.WriteAllBytes(Path.Combine(folder, name), bytes);
            Console.WriteLine($"{name}: {bytes.Length} bytes");
        }
        var curves = Path.Combine(folder, "..", "curves");
        Directory.CreateDirectory(curves);
        foreach (var (name, make) in ExampleCurves.All)
        {
            File.WriteAllBytes(Path.Combine(curves, name), make());
            Console.WriteLine($"curves/{name}");
        }
        var turtles = Path.Combine(folder, "..", "turtle");
        Directory.CreateDirectory(turtles);
        File.WriteAllBytes(Path.Combine(turtles, WorldMap.FileName), WorldMap.ToPng());
        Console.WriteLine($"turtle/{WorldMap.FileName}");
        return 0;
    }

    private static string? ModelsFolder()
    {
        for (var folder = new DirectoryInfo(AppContext.BaseDirectory); folder is not null; folder = folder.Parent)
        {
            if (File.Exists(Path.Combine(folder.FullName, "Caterpillar.sln"))) return Path.Combine(folder.FullName, "examples", "models");
        }
        return null;
    }
}
