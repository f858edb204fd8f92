namespace Caterpillar.Curved;

/// <summary>A height map over a rectangle as a plan.</summary>
internal sealed class ImagePlan(GrayImage image, Bounds box) : PlanSurface
{
    private readonly GrayImage _image = image ?? throw new ArgumentNullException(nameof(image));
    private readonly Bounds _box = box.Size.X > 0 && box.Size.Y > 0 ? box
        : throw new ArgumentException("The rectangle of a height map must have an area.", nameof(box));

    public override double Detail => Math.Max(0.1, Math.Min(_box.Size.X / _image.Width, _box.Size.Y / _image.Height));

    public override bool Covers(double x, double y)
    {
        const double Edge = 1e-6;
        return x >= _box.Min.X - Edge && x <= _box.Max.X + Edge && y >= _box.Min.Y - Edge && y <= _box.Max.Y + Edge;
    }

    public override double Height(double x, double y)
    {
        var brightness = _image.BetweenClamped((x - _box.Min.X) / _box.Size.X, (y - _box.Min.Y) / _box.Size.Y);
        return _box.Min.Z + brightness * _box.Size.Z;
    }
}
