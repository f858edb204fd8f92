namespace Caterpillar.Basics;

/// <summary>Uninitialized memory.</summary>
internal static class Buffers
{
    /// <summary>An array with arbitrary content, to be written before it is read. Faster than an array of zeros.</summary>
    public static T[] Unfilled<T>(int length)
#if NET8_0_OR_GREATER
        => System.GC.AllocateUninitializedArray<T>(length);
#else
        => new T[length];
#endif

    /// <summary>Sets a part of an array.</summary>
    public static void Fill<T>(T[] array, int from, int to, T value)
    {
#if NET8_0_OR_GREATER
        System.Array.Fill(array, value, from, to - from);
#else
        for (var i = from; i < to; i++) array[i] = value;
#endif
    }
}
