using System;
using System.IO;
using System.Linq;
using SkiaSharp;

namespace Caterpillar.CanvasPictures;

/// <summary>Draws into an image, two pixels for one of the canvas.</summary>
internal sealed class PngSurface : ISurface, IDisposable
{
    private const float Scale = 2;
    private const string Fonts = "/usr/share/fonts";
    private static readonly string[] Sans = ["Arial", "Liberation Sans", "DejaVu Sans Condensed", "Helvetica"];
    private static readonly string[] Mono = ["Consolas", "DejaVu Sans Mono", "Menlo", "Courier New"];
    private static readonly Lazy<string[]> Files = new(() => Directory.Exists(Fonts) ? Directory.GetFiles(Fonts, "*.ttf", SearchOption.AllDirectories) : []);
    private readonly SKSurface _surface;

    public PngSurface(Box extent)
    {
        _surface = SKSurface.Create(new SKImageInfo((int)(extent.Width * Scale), (int)(extent.Height * Scale)));
        _surface.Canvas.Scale(Scale);
        _surface.Canvas.Translate(-(float)extent.X, -(float)extent.Y);
    }

    public void Rectangle(Box box, double radius, string fill, string edge, double opacity = 1)
    {
        var rectangle = new SKRoundRect(Of(box), (float)radius);
        using var inside = Paint(fill, opacity);
        using var outline = Line(edge, 1, opacity);
        _surface.Canvas.DrawRoundRect(rectangle, inside);
        _surface.Canvas.DrawRoundRect(rectangle, outline);
    }

    public void Curve(Wire wire, string color, double width, bool dashed)
    {
        var (a, b, reach) = (wire.Start, wire.End, wire.Reach);
        using var builder = new SKPathBuilder();
        builder.MoveTo((float)a.X, (float)a.Y);
        builder.CubicTo((float)(a.X + reach), (float)a.Y, (float)(b.X - reach), (float)b.Y, (float)b.X, (float)b.Y);
        using var path = builder.Detach();
        using var paint = Line(color, width, 1);
        using var dashes = dashed ? SKPathEffect.CreateDash([7, 4], 0) : null;
        paint.PathEffect = dashes;
        _surface.Canvas.DrawPath(path, paint);
    }

    public void Disc(Spot center, double radius, string fill, string edge)
    {
        using var inside = Paint(fill, 1);
        using var outline = Line(edge, 1, 1);
        _surface.Canvas.DrawCircle((float)center.X, (float)center.Y, (float)radius, inside);
        _surface.Canvas.DrawCircle((float)center.X, (float)center.Y, (float)radius, outline);
    }

    public void Text(string text, Spot at, double size, Side side, string color, bool mono = false, bool bold = false)
    {
        using var font = new SKFont(Face(mono ? Mono : Sans, bold), (float)size) { Subpixel = true };
        using var paint = Paint(color, 1);
        var align = side == Side.Start ? SKTextAlign.Left : side == Side.Middle ? SKTextAlign.Center : SKTextAlign.Right;
        _surface.Canvas.DrawText(text, (float)at.X, (float)at.Y, align, font, paint);
    }

    public void Image(Box box, byte[] png)
    {
        using var image = SKImage.FromEncodedData(png);
        _surface.Canvas.DrawImage(image, Of(box), new SKSamplingOptions(SKFilterMode.Linear));
    }

    public void Save(string file)
    {
        using var image = _surface.Snapshot();
        using var data = image.Encode(SKEncodedImageFormat.Png, 100);
        File.WriteAllBytes(file, data.ToArray());
    }

    public void Dispose() => _surface.Dispose();

    // The first font that the machine has. Skia without the system's libraries knows none on Linux: there it is a file.
    private static SKTypeface Face(string[] names, bool bold)
    {
        foreach (var name in names)
        {
            var face = SKFontManager.Default.MatchFamily(name, bold ? SKFontStyle.Bold : SKFontStyle.Normal);
            if (face is not null && face.FamilyName == name) return face;
        }
        foreach (var name in names)
        {
            var start = name.Replace(" ", "", StringComparison.Ordinal) + (bold ? "-Bold.ttf" : "");
            string[] wanted = bold ? [start] : [start + ".ttf", start + "-Regular.ttf"];
            var file = Files.Value.FirstOrDefault(f => wanted.Contains(Path.GetFileName(f)));
            if (file is not null) return SKTypeface.FromFile(file);
        }
        return SKTypeface.Default;
    }

    private static SKPaint Paint(string color, double opacity)
        => new() { Color = SKColor.Parse(color).WithAlpha((byte)Math.Round(255 * opacity)), IsAntialias = true };

    private static SKPaint Line(string color, double width, double opacity)
    {
        var paint = Paint(color, opacity);
        paint.Style = SKPaintStyle.Stroke;
        paint.StrokeWidth = (float)width;
        return paint;
    }

    private static SKRect Of(Box box) => new((float)box.X, (float)box.Y, (float)box.Right, (float)box.Bottom);
}
