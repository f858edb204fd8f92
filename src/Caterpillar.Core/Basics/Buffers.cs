namespace Caterpillar.Basics;

/// <summary>Memory for those who fill it.</summary>
internal static class Buffers
{
    /// <summary>An array with any content, which must be written before it is read; it costs less than one of zeros.</summary>
    public static T[] Unfilled<T>(int length)
#if NET8_0_OR_GREATER
        => System.GC.AllocateUninitializedArray<T>(length);
#else
        => new T[length];
#endif
}
