using System;
using System.IO;
using Caterpillar.Package;

// Packs the plug-in: one package for Rhino 8 with a folder for each runtime, one for Rhino 7.
if (args.Length != 6)
{
    Console.Error.WriteLine("Usage: dotnet run --project tools/Caterpillar.Package -- NET48_FOLDER NET8_FOLDER ICON TEXTS_FOLDER VERSION OUTPUT_FOLDER");
    return 2;
}
var (net48, net8, icon, texts, version, output) = (args[0], args[1], args[2], args[3], args[4], args[5]);
try
{
    Directory.CreateDirectory(output);
    foreach (var package in new[] { YakPackage.ForRhino8(net48, net8, icon, texts, version), YakPackage.ForRhino7(net48, icon, texts, version) })
    {
        var file = Path.Combine(output, package.FileName);
        using (var stream = File.Create(file)) package.Write(stream);
        Console.WriteLine($"{file} ({new FileInfo(file).Length} bytes)");
    }
    return 0;
}
catch (InvalidOperationException problem)
{
    Console.Error.WriteLine(problem.Message);
    return 1;
}
