using System;
using System.IO;

namespace Caterpillar.Examples.CSharp;

/// <summary>Runs all examples: <c>dotnet run --project examples/csharp -f net8.0 -- MODEL FOLDER</c>.</summary>
internal static class Program
{
    private static int Main(string[] arguments)
    {
        if (arguments.Length != 2)
        {
            Console.Error.WriteLine("usage: dotnet run --project examples/csharp -f net8.0 -- MODEL FOLDER");
            return 2;
        }
        string In(string name) => Path.Combine(arguments[1], name);
        Directory.CreateDirectory(arguments[1]);
        SliceWithProfile.Run(arguments[0], In("sliced.gcode"));
        SliceSeveral.Run([arguments[0], arguments[0]], In("several.gcode"));
        TurtleStar.Run(In("star.gcode"));
        File.WriteAllText(In("tower.turtle"), "param layers = 10\nstart 100 100 0.3\nrepeat layers [\n  repeat 4 [ forward 20; left 90 ]\n  lift 0.3\n]\n");
        TurtleFile.Run(In("tower.turtle"), In("tower.gcode"));
        File.WriteAllText(In("bow.csv"), "x,y,z\n80,100,0.2\n110,120,0.2\n140,100,0.2\n");
        CurveFile.Run(In("bow.csv"), In("bow.gcode"));
        TraceVase.Run(In("vase.gcode"));
        CustomPath.Run(In("wave.gcode"));
        EditFile.Run(In("sliced.gcode"), In("edited.gcode"));
        DeformFile.Run(In("sliced.gcode"), In("twisted.gcode"));
        ConvertFile.Run(In("sliced.gcode"), In("klipper.gcode"));
        foreach (var finding in SafeEdit.Run(In("sliced.gcode"), In("moved.gcode"))) Console.WriteLine(finding);
        foreach (var finding in CheckFile.Run(In("sliced.gcode"))) Console.WriteLine(finding);
        Console.WriteLine($"{FileStatistics.Run(In("sliced.gcode")).Duration:0} s");
        DrawImage.Run(In("vase.gcode"), In("vase.png"));
        return 0;
    }
}
