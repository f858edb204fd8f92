using System;
using Caterpillar.Files;
using Caterpillar.Geometry;

namespace Caterpillar.Slicing;

/// <summary>A height map over a rectangle as a plan.</summary>
internal sealed class PicturePlan : PlanSurface
{
    private readonly GrayImage _picture;
    private readonly Bounds _box;

    public PicturePlan(GrayImage picture, Bounds box)
    {
        _picture = picture ?? throw new ArgumentNullException(nameof(picture));
        if (!(box.Size.X > 0 && box.Size.Y > 0)) throw new ArgumentException("The rectangle of a height map needs an area.", nameof(box));
        _box = box;
    }

    public override double Detail => Math.Max(0.1, Math.Min(_box.Size.X / _picture.Width, _box.Size.Y / _picture.Height));

    public override bool Covers(double x, double y)
    {
        const double Edge = 1e-6;
        return x >= _box.Min.X - Edge && x <= _box.Max.X + Edge && y >= _box.Min.Y - Edge && y <= _box.Max.Y + Edge;
    }

    public override double Height(double x, double y)
    {
        // From the middle of the first dot to that of the last; rows run from the top.
        var u = Clamp((x - _box.Min.X) / _box.Size.X * _picture.Width - 0.5, _picture.Width - 1);
        var v = Clamp((_box.Max.Y - y) / _box.Size.Y * _picture.Height - 0.5, _picture.Height - 1);
        int left = (int)u, top = (int)v;
        int right = Math.Min(left + 1, _picture.Width - 1), bottom = Math.Min(top + 1, _picture.Height - 1);
        var upper = _picture[left, top] + (_picture[right, top] - _picture[left, top]) * (u - left);
        var lower = _picture[left, bottom] + (_picture[right, bottom] - _picture[left, bottom]) * (u - left);
        return _box.Min.Z + (upper + (lower - upper) * (v - top)) * _box.Size.Z;
    }

    private static double Clamp(double value, double most) => Math.Max(0, Math.Min(most, value));
}
