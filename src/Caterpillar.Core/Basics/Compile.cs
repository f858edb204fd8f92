namespace Caterpillar.Basics;

/// <summary>Options for the compilation of methods.</summary>
internal static class Compile
{
    /// <summary>
    /// Full optimization at the first call (AggressiveOptimization, which .NET Standard 2.0 does not have): for long loops that are entered a few times only,
    /// so that the runtime does not recompile them.
    /// </summary>
    public const MethodImplOptions Optimized = (MethodImplOptions)512;
}
