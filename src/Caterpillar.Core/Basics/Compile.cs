using System.Runtime.CompilerServices;

namespace Caterpillar.Basics;

/// <summary>How the runtime is to compile a method.</summary>
internal static class Compile
{
    /// <summary>
    /// Fully optimized at the first call (AggressiveOptimization, which .NET Standard 2.0 does not name): for long loops that are entered a few times only,
    /// so that the runtime would not come to compile them again.
    /// </summary>
    public const MethodImplOptions Optimized = (MethodImplOptions)512;
}
