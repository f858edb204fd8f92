namespace Caterpillar.Display;

/// <summary>Draws extrusions of an elliptic section with depth and shading into an image of twice the requested size.</summary>
internal sealed class ExtrusionCanvas
{
    // Light from the upper left, toward the eye: right, up and toward the viewer in the image.
    private static readonly Vec3 Light = new Vec3(-0.45, 0.6, 0.66).Unit();

    private readonly RasterImage _image;
    private readonly float[] _near;
    private readonly View _view;
    private double _scale = 1;
    private double _left;
    private double _top;

    public ExtrusionCanvas(int width, int height, Rgb background, View view)
    {
        _image = new RasterImage(width, height, background);
        _near = new float[width * height];
        for (var i = 0; i < _near.Length; i++) _near[i] = float.MinValue;
        _view = view;
    }

    /// <summary>Chooses the scale so that the box fills the image with a small margin.</summary>
    public void Fit(Bounds box)
    {
        var seen = Bounds.Empty;
        for (var corner = 0; corner < 8; corner++)
        {
            seen = seen.Include(_view.Project(new Vec3(
                (corner & 1) == 0 ? box.Min.X : box.Max.X, (corner & 2) == 0 ? box.Min.Y : box.Max.Y, (corner & 4) == 0 ? box.Min.Z : box.Max.Z)));
        }
        _scale = 0.92 * Math.Min(_image.Width / Math.Max(seen.Size.X, 1), _image.Height / Math.Max(seen.Size.Y, 1));
        _left = _image.Width / 2.0 - seen.Center.X * _scale;
        _top = _image.Height / 2.0 + seen.Center.Y * _scale;
    }

    /// <summary>Draws an extrusion of a width and a height in mm, whose top goes from one point to another. Width 0 = a thin flat line.</summary>
    public void Extrusion(Vec3 from, Vec3 to, double width, double height, Rgb color)
    {
        var middle = new Vec3(0, 0, height / 2);
        var a = _view.Project(from - middle);
        var b = _view.Project(to - middle);
        // An ellipsoid goes along the line. In the image it is an ellipse, leaning and deep toward the eye.
        var up = _view.Project(Vec3.UnitZ);
        double across = Math.Max(width / 2 * _scale, width > 0 ? 0.8 : 0.6), high = width > 0 ? Math.Max(height / 2 * _scale, 0.8) : across;
        var tall = Math.Sqrt(across * across * up.Z * up.Z + high * high * up.Y * up.Y);
        var lean = (high * high - across * across) * up.Y * up.Z / (tall * tall);
        var deep = across * high / tall;
        double ax = _left + a.X * _scale, ay = _top - a.Y * _scale, bx = _left + b.X * _scale, by = _top - b.Y * _scale;
        int x0 = First(Math.Min(ax, bx) - across), x1 = Last(Math.Max(ax, bx) + across, _image.Width);
        int y0 = First(Math.Min(ay, by) - tall), y1 = Last(Math.Max(ay, by) + tall, _image.Height);
        // In units of the ellipse.
        double dx = (bx - ax) / across, dy = (by - ay) / tall;
        var lengthSquared = dx * dx + dy * dy;
        for (var y = y0; y <= y1; y++)
        {
            for (var x = x0; x <= x1; x++)
            {
                double px = (x + 0.5 - ax) / across, py = (y + 0.5 - ay) / tall;
                var t = lengthSquared > 0 ? Math.Max(0, Math.Min(1, (px * dx + py * dy) / lengthSquared)) : 0;
                double ox = px - t * dx, oy = py - t * dy;
                var away = ox * ox + oy * oy;
                if (away > 1) continue;
                var bulge = Math.Sqrt(1 - away);
                var near = (float)(a.Z + (b.Z - a.Z) * t + (width > 0 ? (bulge * deep - lean * oy * tall) / _scale : 0));
                var i = y * _image.Width + x;
                if (near <= _near[i]) continue;
                _near[i] = near;
                var light = width > 0 ? 0.45 + 0.6 * Math.Max(0, Light.X * ox - Light.Y * oy + Light.Z * bulge) : 1;
                _image[x, y] = color.Scale(light);
            }
        }
    }

    public RasterImage Finish() => _image.Halved();

    private static int First(double edge) => Math.Max(0, (int)Math.Floor(Math.Max(edge, 0)));

    private static int Last(double edge, int size) => (int)Math.Floor(Math.Min(edge, size - 1.0));
}
