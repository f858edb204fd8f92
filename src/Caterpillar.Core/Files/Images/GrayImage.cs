namespace Caterpillar.Files;

/// <summary>Brightness of pixels, 0 (black) to 1 (white), rows from the top. Immutable.</summary>
public sealed class GrayImage
{
    private readonly double[] _pixels;

    /// <exception cref="ArgumentException">The number of pixels is not width × height, or a size is below 1.</exception>
    public GrayImage(int width, int height, double[] pixels)
    {
        if (width < 1 || height < 1) throw new ArgumentException("An image must have at least one pixel.", nameof(width));
        if (pixels is null || pixels.Length != (long)width * height) throw new ArgumentException("An image needs width × height pixels.", nameof(pixels));
        Width = width;
        Height = height;
        _pixels = (double[])pixels.Clone();
    }

    /// <summary>Pixels.</summary>
    public int Width { get; }

    /// <summary>Pixels.</summary>
    public int Height { get; }

    /// <summary>Brightness of a pixel, x from the left, y from the top.</summary>
    public double this[int x, int y] => _pixels[y * Width + x];

    /// <summary>The nearest pixel at u from the left and v from the bottom. The image repeats in u and is clamped in v.</summary>
    internal double Nearest(double u, double v)
    {
        if (!IsPlace(u, v)) return double.NaN;
        var x = (int)((u - Math.Floor(u)) * Width);
        return this[Math.Min(x, Width - 1), Row(Math.Floor((1 - v) * Height))];
    }

    /// <summary>As <see cref="Nearest"/>, linear between the centers of pixels.</summary>
    internal double Between(double u, double v) =>
        IsPlace(u, v) ? Bilinear((u - Math.Floor(u)) * Width - 0.5, (1 - v) * Height - 0.5, repeats: true) : double.NaN;

    /// <summary>As <see cref="Between"/>, but clamped in u, too.</summary>
    internal double BetweenClamped(double u, double v) => IsPlace(u, v) ? Bilinear(u * Width - 0.5, (1 - v) * Height - 0.5, repeats: false) : double.NaN;

    private double Bilinear(double x, double y, bool repeats)
    {
        double fx = Math.Floor(x), fy = Math.Floor(y);
        int left = Column(fx, repeats), right = Column(fx + 1, repeats), top = Row(fy), bottom = Row(fy + 1);
        var upper = this[left, top] + (this[right, top] - this[left, top]) * (x - fx);
        var lower = this[left, bottom] + (this[right, bottom] - this[left, bottom]) * (x - fx);
        return upper + (lower - upper) * (y - fy);
    }

    private static bool IsPlace(double u, double v) => !double.IsNaN(u - u) && !double.IsNaN(v - v);

    private int Row(double y) => (int)Math.Max(0, Math.Min(Height - 1, y));

    private int Column(double x, bool repeats)
    {
        if (!repeats) return (int)Math.Max(0, Math.Min(Width - 1, x));
        return x < 0 ? (int)x + Width : x >= Width ? (int)x - Width : (int)x;
    }
}
