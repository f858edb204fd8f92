namespace Caterpillar.Toolpaths;

/// <summary>
/// Bounds of some extrusions in a bin of a <see cref="Deposit"/>: their highest top, and a plane that is nowhere below their axes. On a slope, the plane of one
/// layer is clearly below the next one, while the tops of many are above it elsewhere in the bin.
/// </summary>
internal readonly struct DepositBlock
{
    /// <summary>Highest top, mm; and with all blocks before it.</summary>
    public readonly double Top, TopSoFar;

    /// <summary>Half of the largest width, mm.</summary>
    public readonly double Half;

    // The height of the plane at the origin, and how it rises along X and Y.
    private readonly double _height, _riseX, _riseY;
    private readonly bool _hasPlane;

    public DepositBlock(DepositEntry[] entries, int first, double topBefore)
    {
        Top = entries[first].Top;
        for (var i = first + 1; i < first + DepositBin.Block; i++) Top = Math.Max(Top, entries[i].Top);
        TopSoFar = Math.Max(Top, topBefore);
    }

    private DepositBlock(in DepositBlock tops, DepositEntry[] entries, int first, ExtrusionStore store)
    {
        const int Ends = 2 * DepositBin.Block;
        (Top, TopSoFar, _hasPlane) = (tops.Top, tops.TopSoFar, true);
        var isLevel = true;
        for (var i = first; i < first + DepositBin.Block; i++) isLevel &= entries[i].IsLevel && entries[i].Top == Top;
        if (isLevel) return;
        var center = Vec3.Zero;
        for (var i = 0; i < Ends; i++)
        {
            center += End(i) / Ends;
            Half = Math.Max(Half, store[entries[first + i / 2].Extrusion].Half);
        }
        // Least squares; level across a line on which all points lie.
        double xx = 1e-6, xy = 0, yy = 1e-6, xz = 0, yz = 0;
        for (var i = 0; i < Ends; i++)
        {
            var d = End(i) - center;
            (xx, xy, yy, xz, yz) = (xx + d.X * d.X, xy + d.X * d.Y, yy + d.Y * d.Y, xz + d.X * d.Z, yz + d.Y * d.Z);
        }
        var determinant = xx * yy - xy * xy;
        (_riseX, _riseY) = ((yy * xz - xy * yz) / determinant, (xx * yz - xy * xz) / determinant);
        Rise = Math.Sqrt(_riseX * _riseX + _riseY * _riseY);
        var most = double.NegativeInfinity;
        for (var i = 0; i < Ends; i++) most = Math.Max(most, -Above(End(i)));
        _height = most;

        Vec3 End(int i) => i % 2 == 0 ? store[entries[first + i / 2].Extrusion].A : store[entries[first + i / 2].Extrusion].B;
    }

    /// <summary>The same with its plane, which few blocks need.</summary>
    public DepositBlock WithPlane(DepositEntry[] entries, int first, ExtrusionStore store)
        => _hasPlane ? this : new DepositBlock(this, entries, first, store);

    /// <summary>How much the plane rises for each mm; 0 = all extrusions are equally high.</summary>
    public double Rise { get; }

    /// <summary>Height of the plane above a point, mm.</summary>
    public double Above(Vec3 p) => _height + _riseX * p.X + _riseY * p.Y - p.Z;
}
