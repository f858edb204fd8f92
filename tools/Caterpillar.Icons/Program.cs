using System;
using System.IO;
using Caterpillar.Icons;

// Draws every icon of the plug-in into a folder, as 24 × 24 PNG, always with the same bytes.
if (args.Length != 1)
{
    Console.Error.WriteLine("Usage: dotnet run --project tools/Caterpillar.Icons -- FOLDER");
    return 2;
}
Directory.CreateDirectory(args[0]);
foreach (var (name, draw) in Drawings.All)
{
    var canvas = new Canvas();
    draw(canvas);
    File.WriteAllBytes(Path.Combine(args[0], name + ".png"), Png.Encode(canvas.Finish(), Canvas.Size));
    // The package manager shows a larger one.
    if (name == "Plugin") File.WriteAllBytes(Path.Combine(args[0], "..", "package.png"), Png.Encode(canvas.FinishLarge(), Canvas.LargeSize));
}
Console.WriteLine($"{Drawings.All.Count} icons in {args[0]}");
return 0;
