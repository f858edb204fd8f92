namespace Caterpillar.Files;

/// <summary>The checksum Adler-32 of zlib.</summary>
internal static class Adler32
{
    private const uint Modulus = 65521;

    public static uint Of(byte[] bytes)
    {
        uint a = 1, b = 0;
        for (var at = 0; at < bytes.Length;)
        {
            // So many fit without an overflow.
            for (var stop = Math.Min(bytes.Length, at + 5552); at < stop; at++)
            {
                a += bytes[at];
                b += a;
            }
            a %= Modulus;
            b %= Modulus;
        }
        return b << 16 | a;
    }
}
