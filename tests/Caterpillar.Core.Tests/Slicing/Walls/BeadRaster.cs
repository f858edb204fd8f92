using System;
using System.Collections.Generic;
using Caterpillar.Geometry;

namespace Caterpillar.Tests.Slicing;

/// <summary>
/// Counts on a grid of pixels how often beads cover a place. A bead is as wide as its area over the thickness of the layer, with round joints and ends. Where
/// a path goes
/// on around a corner it does not cover itself twice; where it comes back later it does.
/// </summary>
internal sealed class BeadRaster
{
    private readonly double _pixel;
    private readonly Vec3 _origin;
    private readonly byte[] _count;
    private readonly int[] _path;
    private readonly float[] _along;
    private int _paths;

    public BeadRaster(Bounds bounds, double pixel)
    {
        _pixel = pixel;
        _origin = bounds.Min - new Vec3(1, 1);
        Width = (int)((bounds.Size.X + 2) / pixel) + 1;
        Height = (int)((bounds.Size.Y + 2) / pixel) + 1;
        _count = new byte[Width * Height];
        _path = new int[Width * Height];
        _along = new float[Width * Height];
    }

    public int Width { get; }

    public int Height { get; }

    public byte this[int x, int y] => _count[y * Width + x];

    public Vec3 Center(int x, int y) => _origin + new Vec3((x + 0.5) * _pixel, (y + 0.5) * _pixel);

    /// <summary>Adds a path; the spacings, mm, are those at its points.</summary>
    public void Add(IReadOnlyList<Vec3> points, IReadOnlyList<double> spacings, bool closed)
    {
        _paths++;
        var n = points.Count;
        var segments = closed ? n : n - 1;
        var total = 0.0;
        for (var i = 0; i < segments; i++) total += (points[(i + 1) % n] - points[i]).LengthXY;
        var done = 0.0;
        for (var i = 0; i < segments; i++)
        {
            Vec3 a = points[i], b = points[(i + 1) % n];
            Capsule(a, b, spacings[i] / 2, spacings[(i + 1) % n] / 2, done, closed ? total : double.PositiveInfinity);
            done += (b - a).LengthXY;
        }
    }

    /// <summary>Areas in mm²: of the region, of it without a bead, of it under two and more, and of beads outside it.</summary>
    public (double Area, double Uncovered, double Double, double Outside) Measure(Region region)
    {
        long all = 0, none = 0, twice = 0, outside = 0;
        for (var y = 0; y < Height; y++)
        {
            var inside = Row(region, y);
            for (var x = 0; x < Width; x++)
            {
                var count = _count[y * Width + x];
                if (inside[x])
                {
                    all++;
                    if (count == 0) none++;
                    if (count > 1) twice += count - 1;
                }
                else if (count > 0)
                {
                    outside++;
                }
            }
        }
        var area = _pixel * _pixel;
        return (all * area, none * area, twice * area, outside * area);
    }

    /// <summary>Which pixels of a row have their center in the region.</summary>
    public bool[] Row(Region region, int y)
    {
        var inside = new bool[Width];
        var crossings = new List<double>();
        var h = Center(0, y).Y;
        foreach (var contour in region.Contours)
        {
            for (var i = 0; i < contour.Count; i++)
            {
                Vec3 a = contour[i], b = contour[(i + 1) % contour.Count];
                if (a.Y > h != b.Y > h) crossings.Add(a.X + (b.X - a.X) * (h - a.Y) / (b.Y - a.Y));
            }
        }
        crossings.Sort();
        for (var k = 0; k + 1 < crossings.Count; k += 2)
        {
            var from = Math.Max(0, (int)Math.Ceiling((crossings[k] - _origin.X) / _pixel - 0.5));
            for (var x = from; x < Width && _origin.X + (x + 0.5) * _pixel < crossings[k + 1]; x++) inside[x] = true;
        }
        return inside;
    }

    private void Capsule(Vec3 a, Vec3 b, double ra, double rb, double start, double total)
    {
        var r = Math.Max(ra, rb);
        int x0 = Pixel(Math.Min(a.X, b.X) - r - _origin.X, Width), x1 = Pixel(Math.Max(a.X, b.X) + r - _origin.X, Width);
        int y0 = Pixel(Math.Min(a.Y, b.Y) - r - _origin.Y, Height), y1 = Pixel(Math.Max(a.Y, b.Y) + r - _origin.Y, Height);
        var d = b - a;
        var length = d.LengthXY;
        for (var y = y0; y <= y1; y++)
        {
            for (var x = x0; x <= x1; x++)
            {
                var p = Center(x, y) - a;
                var t = length > 0 ? Math.Min(Math.Max((p.X * d.X + p.Y * d.Y) / (length * length), 0), 1) : 0;
                var radius = ra + (rb - ra) * t;
                if ((p - d * t).LengthXY > radius) continue;
                var k = y * Width + x;
                var along = start + t * length;
                var apart = Math.Abs(along - _along[k]);
                if (_path[k] == _paths && Math.Min(apart, total - apart) < 3 * r + 0.1)
                {
                    _along[k] = (float)along;
                    continue;
                }
                _path[k] = _paths;
                _along[k] = (float)along;
                if (_count[k] < 255) _count[k]++;
            }
        }
    }

    private int Pixel(double mm, int size) => (int)Math.Min(Math.Max(mm / _pixel, 0), size - 1);
}
