using BenchmarkDotNet.Running;

namespace Caterpillar.Bench;

/// <summary>
/// <c>dotnet run -c Release --project bench -- --filter *</c>; a class or method name instead of * runs part of it.
/// <c>dotnet run -c Release --project bench -- times FOLDER</c>: print times against other slicers for the meshes of a folder.
/// </summary>
internal static class Program
{
    private static void Main(string[] arguments)
    {
        if (arguments is ["times", var folder]) PrintTimes.Run(folder);
        else BenchmarkSwitcher.FromAssembly(typeof(Program).Assembly).Run(arguments);
    }
}
