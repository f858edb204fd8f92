namespace Caterpillar.Files;

/// <summary>A color, 0 to 255 in each channel (sRGB).</summary>
public readonly record struct Rgb(byte R, byte G, byte B)
{
    /// <summary>A mixture in sRGB, <paramref name="t"/> from 0 (a) to 1 (b).</summary>
    public static Rgb Mix(Rgb a, Rgb b, double t) => new(Channel(a.R, b.R, t), Channel(a.G, b.G, t), Channel(a.B, b.B, t));

    /// <summary>The color made darker (below 1) or lighter (above 1).</summary>
    public Rgb Scale(double by) => new(Clamp(R * by), Clamp(G * by), Clamp(B * by));

    private static byte Channel(byte a, byte b, double t) => Clamp(a + (b - a) * t);

    private static byte Clamp(double value) => value <= 0 ? (byte)0 : value >= 255 ? (byte)255 : (byte)(value + 0.5);
}
