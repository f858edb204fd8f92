using System.Globalization;
using BenchmarkDotNet.Running;

namespace Caterpillar.Bench;

/// <summary>
/// <c>dotnet run -c Release --project bench -- --filter *</c>; a class or method name instead of * runs part of it.
/// <c>dotnet run -c Release --project bench -- times FOLDER MODEL...</c>: print times and short moves against other slicers, whose files are kept in a folder.
/// <c>dotnet run -c Release --project bench -- parts FOLDER</c>: plain parts as STL: plates, disks, frames, a gear.
/// <c>dotnet run -c Release --project bench -- supports FOLDER [NAME...]</c>: what supports cost, touch and hold, against other slicers.
/// <c>dotnet run -c Release --project bench -- coverage MODEL FILE.gcode...</c>: what the beads of solid prints leave open and cover twice (bench/coverage.sh).
/// <c>dotnet run -c Release --project bench -- damaged FOLDER FIRST COUNT OUT</c>, <c>lost GOOD.gcode BAD.gcode</c>: layers that damaged meshes lose
/// (bench/damaged.sh).
/// <c>dotnet run -c Release --project bench -- targets PROGRAM BIG.gcode MESHES</c>: every target of speed that can be measured without other programs, with
/// the published PROGRAM, as a table (bench/targets.sh).
/// <c>dotnet run -c Release --project bench -- chart bench/RESULTS.md</c>: the chart of that table.
/// <c>dotnet run -c Release --project bench -- deviation MODEL...</c>: how far outer walls lie from the exact sections.
/// <c>dotnet run -c Release --project bench -- stages MODEL...</c>: the stages of a slice.
/// <c>dotnet run -c Release --project bench -- curved PROGRAM MODELS</c>: curved against planar slicing with the published PROGRAM.
/// <c>dotnet run -c Release --project bench -- guard</c>: what reading back costs beside writing.
/// <c>dotnet run -c Release --project bench -- mesh TRIANGLES FILE.stl</c>: a bumpy sphere of about so many triangles.
/// <c>dotnet run -c Release --project bench -- pins COUNT FILE.stl</c>: so many pins as one mesh (bench/growth.sh).
/// <c>dotnet run -c Release --project bench -- stl MODEL FILE.stl</c>: a model as binary STL, which all slicers read.
/// </summary>
internal static class Program
{
    private static void Main(string[] arguments)
    {
        if (arguments is ["times", var folder, _, ..]) PrintTimes.Run(folder, arguments[2..]);
        else if (arguments is ["parts", var parts]) Samples.WriteParts(parts);
        else if (arguments is ["supports", _, ..]) SupportTable.Run(arguments[1], arguments[2..]);
        else if (arguments is ["coverage", _, _, ..]) Coverage.Run(arguments[1..]);
        else if (arguments is ["damaged", var models, var first, var count, var target])
            DamagedMeshes.Run(models, int.Parse(first, CultureInfo.InvariantCulture), int.Parse(count, CultureInfo.InvariantCulture), target);
        else if (arguments is ["lost", var good, var bad]) DamagedMeshes.Lost(good, bad);
        else if (arguments is ["chart", var results]) Chart.Make(results);
        else if (arguments is ["targets", var program, var gcode, var meshes]) Targets.Run(program, gcode, meshes);
        else if (arguments is ["stl", var model, var stl]) Samples.WriteStl(model, stl);
        else if (arguments is ["curved", var published, var examples]) CurvedRuns.Run(published, examples);
        else if (arguments is ["deviation", _, ..]) Deviation.Run(arguments[1..]);
        else if (arguments is ["stages", _, ..]) Stages.Run(arguments[1..]);
        else if (arguments is ["guard"]) GuardTimes.Run();
        else if (arguments is ["mesh", var triangles, var file]) Samples.WriteSphere(int.Parse(triangles, CultureInfo.InvariantCulture), file);
        else if (arguments is ["pins", var pins, var pinsFile]) Samples.WritePins(int.Parse(pins, CultureInfo.InvariantCulture), pinsFile);
        else BenchmarkSwitcher.FromAssembly(typeof(Program).Assembly).Run(arguments);
    }
}
