using Caterpillar.Files;

namespace Caterpillar.Display;

/// <summary>Draws round extrusions with depth and shading into an image of twice the requested size.</summary>
internal sealed class ExtrusionCanvas(int width, int height, Rgb background, View view)
{
    // Light from the upper left, toward the eye: right, up and toward the viewer in the image.
    private static readonly Vec3 Light = new Vec3(-0.45, 0.6, 0.66).Unit();

    private readonly RasterImage _image = new(width, height, background);
    private readonly float[] _near = [.. Enumerable.Repeat(float.MinValue, width * height)];
    private double _scale = 1;
    private double _left;
    private double _top;

    /// <summary>Chooses the scale so that the box fills the image with a small margin.</summary>
    public void Fit(Bounds box)
    {
        var seen = Bounds.Empty;
        for (var corner = 0; corner < 8; corner++)
        {
            seen = seen.Include(view.Project(new Vec3(
                (corner & 1) == 0 ? box.Min.X : box.Max.X, (corner & 2) == 0 ? box.Min.Y : box.Max.Y, (corner & 4) == 0 ? box.Min.Z : box.Max.Z)));
        }
        _scale = 0.92 * Math.Min(_image.Width / Math.Max(seen.Size.X, 1), _image.Height / Math.Max(seen.Size.Y, 1));
        _left = _image.Width / 2.0 - seen.Center.X * _scale;
        _top = _image.Height / 2.0 + seen.Center.Y * _scale;
    }

    /// <summary>Draws an extrusion with a diameter in mm. 0 = a thin flat line.</summary>
    public void Extrusion(Vec3 from, Vec3 to, double diameter, Rgb color)
    {
        var a = view.Project(from);
        var b = view.Project(to);
        var radius = Math.Max(diameter / 2 * _scale, diameter > 0 ? 0.8 : 0.6);
        double ax = _left + a.X * _scale, ay = _top - a.Y * _scale, bx = _left + b.X * _scale, by = _top - b.Y * _scale;
        int x0 = First(Math.Min(ax, bx) - radius), x1 = Last(Math.Max(ax, bx) + radius, _image.Width);
        int y0 = First(Math.Min(ay, by) - radius), y1 = Last(Math.Max(ay, by) + radius, _image.Height);
        double dx = bx - ax, dy = by - ay;
        var lengthSquared = dx * dx + dy * dy;
        // How far the band around the line reaches to both sides in a row.
        var reach = Math.Abs(dy) < 1e-6 ? double.PositiveInfinity : radius * Math.Sqrt(lengthSquared) / Math.Abs(dy) + 1;
        for (var y = y0; y <= y1; y++)
        {
            var middle = double.IsInfinity(reach) ? ax : ax + (y + 0.5 - ay) * dx / dy;
            var last = Math.Min(x1, Last(middle + reach, _image.Width));
            for (var x = Math.Max(x0, First(middle - reach)); x <= last; x++)
            {
                double px = x + 0.5 - ax, py = y + 0.5 - ay;
                var t = lengthSquared > 0 ? Math.Max(0, Math.Min(1, (px * dx + py * dy) / lengthSquared)) : 0;
                double ox = px - t * dx, oy = py - t * dy;
                var away = (ox * ox + oy * oy) / (radius * radius);
                if (away > 1) continue;
                var bulge = Math.Sqrt(1 - away);
                var near = (float)(a.Z + (b.Z - a.Z) * t + (diameter > 0 ? bulge * radius / _scale : 0));
                var i = y * _image.Width + x;
                if (near <= _near[i]) continue;
                _near[i] = near;
                var light = diameter > 0 ? 0.45 + 0.6 * Math.Max(0, Light.X * ox / radius - Light.Y * oy / radius + Light.Z * bulge) : 1;
                _image[x, y] = color.Scale(light);
            }
        }
    }

    public RasterImage Finish() => _image.Halved();

    private static int First(double edge) => Math.Max(0, (int)Math.Floor(Math.Max(edge, 0)));

    private static int Last(double edge, int size) => (int)Math.Floor(Math.Min(edge, size - 1.0));
}
