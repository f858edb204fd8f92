using System;

namespace Caterpillar.Icons;

/// <summary>An RGB color.</summary>
internal readonly record struct Ink(byte R, byte G, byte B)
{
    public static Ink Dark { get; } = new(52, 56, 60);

    public static Ink Gray { get; } = new(140, 146, 152);

    public static Ink Light { get; } = new(226, 230, 233);

    public static Ink Green { get; } = new(84, 160, 56);

    public static Ink Orange { get; } = new(228, 120, 36);

    public static Ink Blue { get; } = new(48, 122, 190);
}

/// <summary>A 24 × 24 image drawn with shapes in pixel coordinates, smoothed by 8 × 8 samples, with a light edge, which shows dark strokes on dark
/// backgrounds, and the soft shadow of Grasshopper's icons.</summary>
internal sealed class Canvas
{
    public const int Size = 24;
    public const int LargeSize = 64;
    private const int Samples = 8;
    private const int Fine = Size * Samples;

    // Shadow: 2 px blur, 65/255 black, 1 px to the right and down.
    private const int Blur = 2;
    private const double ShadowAlpha = 65 / 255.0;

    // Width of the edge, px, and its opacity.
    private const double Edge = 0.625;
    private const double EdgeAlpha = 0.7;
    private readonly Ink?[] _fine = new Ink?[Fine * Fine];

    public Canvas Line(double x0, double y0, double x1, double y1, double width, Ink ink) => Fill(ink, (x, y) =>
    {
        double dx = x1 - x0, dy = y1 - y0;
        var t = Math.Clamp(((x - x0) * dx + (y - y0) * dy) / Math.Max(dx * dx + dy * dy, 1e-9), 0, 1);
        return Square(x - x0 - t * dx) + Square(y - y0 - t * dy) <= width * width / 4;
    });

    public Canvas Polyline(double width, Ink ink, params double[] xy)
    {
        for (var i = 0; i + 3 < xy.Length; i += 2) Line(xy[i], xy[i + 1], xy[i + 2], xy[i + 3], width, ink);
        return this;
    }

    public Canvas Disc(double cx, double cy, double radius, Ink ink) => Fill(ink, (x, y) => Square(x - cx) + Square(y - cy) <= radius * radius);

    public Canvas Ring(double cx, double cy, double radius, double width, Ink ink)
        => Fill(ink, (x, y) => Math.Abs(Math.Sqrt(Square(x - cx) + Square(y - cy)) - radius) <= width / 2);

    public Canvas Rect(double x0, double y0, double x1, double y1, Ink ink) => Fill(ink, (x, y) => x >= x0 && x <= x1 && y >= y0 && y <= y1);

    public Canvas Polygon(Ink ink, params double[] xy) => Fill(ink, (x, y) =>
    {
        var inside = false;
        for (int i = 0, j = xy.Length - 2; i < xy.Length; j = i, i += 2)
        {
            if (xy[i + 1] > y != xy[j + 1] > y && x < (xy[j] - xy[i]) * (y - xy[i + 1]) / (xy[j + 1] - xy[i + 1]) + xy[i]) inside = !inside;
        }
        return inside;
    });

    /// <summary>The dark hexagon below the icons of parameters.</summary>
    public Canvas Hexagon() => Polygon(Ink.Dark, 7, 3, 17, 3, 22, 12, 17, 21, 7, 21, 2, 12);

    /// <summary>RGBA, row by row.</summary>
    public byte[] Finish()
    {
        var cover = new double[Size * Size];
        var rgba = new byte[Size * Size * 4];
        for (var pixel = 0; pixel < cover.Length; pixel++)
        {
            double r = 0, g = 0, b = 0, n = 0;
            for (var s = 0; s < Samples * Samples; s++)
            {
                var at = (pixel / Size * Samples + s / Samples) * Fine + pixel % Size * Samples + s % Samples;
                if (_fine[at] is not { } ink) continue;
                (r, g, b, n) = (r + ink.R, g + ink.G, b + ink.B, n + 1);
            }
            cover[pixel] = n / (Samples * Samples);
            if (n == 0) continue;
            rgba[pixel * 4] = (byte)Math.Round(r / n);
            rgba[pixel * 4 + 1] = (byte)Math.Round(g / n);
            rgba[pixel * 4 + 2] = (byte)Math.Round(b / n);
        }
        AddEdge(cover, rgba);
        for (var pixel = 0; pixel < cover.Length; pixel++)
        {
            var shadow = Shadow(cover, pixel % Size - 1, pixel / Size - 1) * ShadowAlpha;
            var alpha = cover[pixel] + shadow * (1 - cover[pixel]);
            for (var c = 0; c < 3 && alpha > 0; c++) rgba[pixel * 4 + c] = (byte)Math.Round(rgba[pixel * 4 + c] * cover[pixel] / alpha);
            rgba[pixel * 4 + 3] = (byte)Math.Round(alpha * 255);
        }
        return rgba;
    }

    /// <summary>RGBA of the same image with 64 × 64 pixels, without a shadow.</summary>
    public byte[] FinishLarge()
    {
        const int Step = Fine / LargeSize;
        var rgba = new byte[LargeSize * LargeSize * 4];
        for (var pixel = 0; pixel < LargeSize * LargeSize; pixel++)
        {
            double r = 0, g = 0, b = 0, n = 0;
            for (var s = 0; s < Step * Step; s++)
            {
                if (_fine[(pixel / LargeSize * Step + s / Step) * Fine + pixel % LargeSize * Step + s % Step] is not { } ink) continue;
                (r, g, b, n) = (r + ink.R, g + ink.G, b + ink.B, n + 1);
            }
            if (n == 0) continue;
            rgba[pixel * 4] = (byte)Math.Round(r / n);
            rgba[pixel * 4 + 1] = (byte)Math.Round(g / n);
            rgba[pixel * 4 + 2] = (byte)Math.Round(b / n);
            rgba[pixel * 4 + 3] = (byte)Math.Round(255 * n / (Step * Step));
        }
        return rgba;
    }

    private Canvas Fill(Ink ink, Func<double, double, bool> inside)
    {
        for (var i = 0; i < _fine.Length; i++)
        {
            if (inside((i % Fine + 0.5) / Samples, (i / Fine + 0.5) / Samples)) _fine[i] = ink;
        }
        return this;
    }

    // Samples beside the drawing count as light ones.
    private void AddEdge(double[] cover, byte[] rgba)
    {
        const int Reach = (int)(Edge * Samples);
        var edge = new double[cover.Length];
        for (var i = 0; i < _fine.Length; i++)
        {
            var (x, y) = (i % Fine, i / Fine);
            if (_fine[i] is null && IsNear(x, y, Reach)) edge[y / Samples * Size + x / Samples] += EdgeAlpha / (Samples * Samples);
        }
        for (var pixel = 0; pixel < cover.Length; pixel++)
        {
            var all = cover[pixel] + edge[pixel];
            byte Mixed(int channel, byte light) => (byte)Math.Round((rgba[pixel * 4 + channel] * cover[pixel] + light * edge[pixel]) / all);
            if (edge[pixel] == 0) continue;
            (rgba[pixel * 4], rgba[pixel * 4 + 1], rgba[pixel * 4 + 2]) = (Mixed(0, Ink.Light.R), Mixed(1, Ink.Light.G), Mixed(2, Ink.Light.B));
            cover[pixel] = all;
        }
    }

    private bool IsNear(int x, int y, int reach)
    {
        for (var dy = -reach; dy <= reach; dy++)
        {
            for (var dx = -reach; dx <= reach; dx++)
            {
                if (dx * dx + dy * dy > reach * reach || x + dx is < 0 or >= Fine || y + dy is < 0 or >= Fine) continue;
                if (_fine[(y + dy) * Fine + x + dx] is not null) return true;
            }
        }
        return false;
    }

    private static double Shadow(double[] cover, int x, int y)
    {
        double sum = 0, weights = 0;
        for (var dy = -Blur; dy <= Blur; dy++)
        {
            for (var dx = -Blur; dx <= Blur; dx++)
            {
                var weight = (Blur + 1 - Math.Abs(dx)) * (Blur + 1 - Math.Abs(dy));
                weights += weight;
                if (x + dx is >= 0 and < Size && y + dy is >= 0 and < Size) sum += weight * cover[(y + dy) * Size + x + dx];
            }
        }
        return sum / weights;
    }

    private static double Square(double v) => v * v;
}
