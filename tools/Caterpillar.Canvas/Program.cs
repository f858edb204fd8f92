using System;
using System.IO;
using System.Linq;
using Caterpillar.CanvasPictures;

// Draws definitions as pictures (SVG and PNG), and says what overlaps, runs back or hides.
if (args.Length != 2)
{
    Console.Error.WriteLine("Usage: dotnet run --project tools/Caterpillar.Canvas -- FILE.ghx|FOLDER PICTURES");
    return 2;
}
var files = Directory.Exists(args[0]) ? Directory.GetFiles(args[0], "*.ghx").OrderBy(f => f, StringComparer.Ordinal).ToArray() : [args[0]];
Directory.CreateDirectory(args[1]);
var faulty = 0;
foreach (var file in files)
{
    var layout = Layout.Of(Definition.Read(File.ReadAllText(file)));
    var picture = Path.Combine(args[1], Path.GetFileNameWithoutExtension(file));
    File.WriteAllText(picture + ".svg", Picture.Svg(layout, Results.None, IconFiles.Of));
    using var surface = new PngSurface(Picture.Extent(layout));
    Picture.Draw(surface, layout, Results.None, IconFiles.Of);
    surface.Save(picture + ".png");
    var faults = Faults.Of(layout);
    if (faults.Count > 0) faulty++;
    Console.WriteLine($"{file}: {layout.Objects.Count} objects, {layout.Wires.Count} wires, {faults.Count} faults");
    foreach (var fault in faults) Console.WriteLine("  " + fault);
}
return faulty == 0 ? 0 : 1;
