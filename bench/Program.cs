using BenchmarkDotNet.Running;

namespace Caterpillar.Bench;

/// <summary><c>dotnet run -c Release --project bench -- --filter *</c>; a class or method name instead of * runs part of it.</summary>
internal static class Program
{
    private static void Main(string[] arguments) => BenchmarkSwitcher.FromAssembly(typeof(Program).Assembly).Run(arguments);
}
