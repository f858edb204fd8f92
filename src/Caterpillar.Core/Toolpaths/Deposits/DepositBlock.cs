namespace Caterpillar.Toolpaths;

/// <summary>
/// Bounds of some extrusions in a bin of a <see cref="Deposit"/>: their highest top, and a plane that is nowhere below the axes of these and of all before
/// them. On a slope, the plane of one layer is clearly below the next one, while the tops of many are above it elsewhere in the bin.
/// </summary>
internal readonly struct DepositBlock
{
    // mm²: across a line on which all points lie, the plane is as steep as the one before.
    private const double Across = 0.01;

    /// <summary>Highest top, mm; and with all blocks before it.</summary>
    public readonly double Top, TopSoFar;

    /// <summary>Half of the largest width so far, mm.</summary>
    public readonly double Half;

    // The height of the plane at the origin, and how it rises along X and Y.
    private readonly double _height, _riseX, _riseY;

    public DepositBlock(DepositEntry[] entries, int first, double topBefore)
    {
        Top = entries[first].Top;
        for (var i = first + 1; i < first + DepositBin.Block; i++) Top = Math.Max(Top, entries[i].Top);
        TopSoFar = Math.Max(Top, topBefore);
    }

    private DepositBlock(in DepositBlock tops, (double X, double Y) rise, double height, double half)
    {
        (Top, TopSoFar, _riseX, _riseY, _height, Half) = (tops.Top, tops.TopSoFar, rise.X, rise.Y, height, half);
        Rise = Math.Sqrt(_riseX * _riseX + _riseY * _riseY);
    }

    /// <summary>How much the plane rises for each mm.</summary>
    public double Rise { get; }

    /// <summary>The same with a plane along its extrusions, not yet above those before.</summary>
    public DepositBlock WithPlane(in DepositBlock before, DepositEntry[] entries, int first, ExtrusionStore store)
    {
        var half = before.Half;
        // Least squares of how they rise above the plane before.
        double xx = Across, xy = 0, yy = Across, xz = 0, yz = 0;
        for (var i = first; i < first + DepositBin.Block; i++)
        {
            ref var extrusion = ref store[entries[i].Extrusion];
            var d = extrusion.B - extrusion.A;
            var z = d.Z - before._riseX * d.X - before._riseY * d.Y;
            (xx, xy, yy, xz, yz) = (xx + d.X * d.X, xy + d.X * d.Y, yy + d.Y * d.Y, xz + d.X * z, yz + d.Y * z);
            half = Math.Max(half, extrusion.Half);
        }
        var determinant = xx * yy - xy * xy;
        var rise = (before._riseX + (yy * xz - xy * yz) / determinant, before._riseY + (xx * yz - xy * xz) / determinant);
        return new DepositBlock(this, rise, double.NegativeInfinity, half).Over(entries, first, store);
    }

    /// <summary>The same with its plane raised above other extrusions.</summary>
    public DepositBlock Over(DepositEntry[] entries, int first, ExtrusionStore store)
    {
        var height = _height;
        for (var i = first; i < first + DepositBin.Block; i++)
        {
            ref var extrusion = ref store[entries[i].Extrusion];
            height = Math.Max(height, Math.Max(Level(extrusion.A), Level(extrusion.B)));
        }
        return new DepositBlock(this, (_riseX, _riseY), height, Half);
    }

    /// <summary>Whether its plane is above that of a block before, from a place as far as a distance in mm along X and Y, and half a width.</summary>
    public bool IsOver(in DepositBlock before, Vec3 center, double distance)
    {
        double byX = before._riseX - _riseX, byY = before._riseY - _riseY;
        return before._height + byX * center.X + byY * center.Y + (Math.Abs(byX) + Math.Abs(byY)) * (distance + Half) <= _height;
    }

    /// <summary>Height of the plane above a point, mm.</summary>
    public double Above(Vec3 p) => _height - Level(p);

    // The height at the origin with which the plane goes through a point.
    private double Level(Vec3 p) => p.Z - _riseX * p.X - _riseY * p.Y;
}
