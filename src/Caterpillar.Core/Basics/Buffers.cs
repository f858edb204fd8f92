namespace Caterpillar.Basics;

/// <summary>Arrays that are written before they are read, and used again.</summary>
internal static class Buffers
{
    /// <summary>An array with arbitrary content, to be written before it is read. Faster than an array of zeros.</summary>
    public static T[] Unfilled<T>(int length)
#if NET8_0_OR_GREATER
        => System.GC.AllocateUninitializedArray<T>(length);
#else
        => new T[length];
#endif

    /// <summary>Makes an array at least so long, with what it holds. The first time it becomes no longer.</summary>
    public static void Reserve<T>(ref T[] array, int length)
    {
        if (array.Length < length) Array.Resize(ref array, Math.Max(length, 2 * array.Length));
    }

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
