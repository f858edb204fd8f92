using System;
using System.IO;

namespace Caterpillar.Examples.CSharp;

/// <summary>Runs all of them: <c>dotnet run --project examples/csharp -- MODEL FOLDER</c>.</summary>
internal static class Program
{
    private static int Main(string[] arguments)
    {
        if (arguments.Length != 2)
        {
            Console.Error.WriteLine("usage: dotnet run --project examples/csharp -- MODEL FOLDER");
            return 2;
        }
        string In(string name) => Path.Combine(arguments[1], name);
        Directory.CreateDirectory(arguments[1]);
        SliceWithProfile.Run(arguments[0], In("sliced.gcode"));
        TurtleStar.Run(In("star.gcode"));
        TraceVase.Run(In("vase.gcode"));
        CustomPath.Run(In("wave.gcode"));
        EditFile.Run(In("sliced.gcode"), In("edited.gcode"));
        DeformFile.Run(In("sliced.gcode"), In("twisted.gcode"));
        ConvertFile.Run(In("sliced.gcode"), In("klipper.gcode"));
        foreach (var finding in SafeEdit.Run(In("sliced.gcode"), In("moved.gcode"))) Console.WriteLine(finding);
        foreach (var finding in CheckFile.Run(In("sliced.gcode"))) Console.WriteLine(finding);
        DrawPicture.Run(In("vase.gcode"), In("vase.png"));
        return 0;
    }
}
