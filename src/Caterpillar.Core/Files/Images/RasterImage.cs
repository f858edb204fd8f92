namespace Caterpillar.Files;

/// <summary>Pixels, three bytes each (red, green, blue), rows from the top.</summary>
public sealed class RasterImage
{
    /// <exception cref="ArgumentOutOfRangeException">A size is below 1 or above 16384.</exception>
    public RasterImage(int width, int height, Rgb background)
    {
        if (width is < 1 or > 16384) throw new ArgumentOutOfRangeException(nameof(width), "An image must be 1 to 16384 pixels wide.");
        if (height is < 1 or > 16384) throw new ArgumentOutOfRangeException(nameof(height), "An image must be 1 to 16384 pixels high.");
        Width = width;
        Height = height;
        Bytes = new byte[width * height * 3];
        for (var i = 0; i < Bytes.Length; i += 3) Set(i, background);
    }

    /// <summary>Pixels.</summary>
    public int Width { get; }

    /// <summary>Pixels.</summary>
    public int Height { get; }

    internal byte[] Bytes { get; }

    /// <summary>The color of a pixel, from the upper left.</summary>
    public Rgb this[int x, int y]
    {
        get
        {
            var i = (y * Width + x) * 3;
            return new Rgb(Bytes[i], Bytes[i + 1], Bytes[i + 2]);
        }
        set => Set((y * Width + x) * 3, value);
    }

    /// <summary>The image at half its size, each pixel the mean of four.</summary>
    internal RasterImage Halved()
    {
        var half = new RasterImage(Width / 2, Height / 2, default);
        var row = Width * 3;
        for (var y = 0; y < half.Height; y++)
        {
            for (var x = 0; x < half.Width * 3; x++)
            {
                var i = 2 * y * row + (x / 3 * 6) + x % 3;
                half.Bytes[y * half.Width * 3 + x] = (byte)((Bytes[i] + Bytes[i + 3] + Bytes[i + row] + Bytes[i + row + 3] + 2) / 4);
            }
        }
        return half;
    }

    private void Set(int i, Rgb color)
    {
        Bytes[i] = color.R;
        Bytes[i + 1] = color.G;
        Bytes[i + 2] = color.B;
    }
}
