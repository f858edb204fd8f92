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

    public DepositBlock(ReadOnlySpan<DepositEntry> entries, ExtrusionStore store, double topBefore)
    {
        var isLevel = true;
        Top = entries[0].Top;
        foreach (ref readonly var entry in entries)
        {
            isLevel &= entry.IsLevel && entry.Top == entries[0].Top;
            Top = Math.Max(Top, entry.Top);
        }
        TopSoFar = Math.Max(Top, topBefore);
        if (isLevel) return;
        var center = Vec3.Zero;
        foreach (ref readonly var entry in entries)
        {
            ref var extrusion = ref store[entry.Extrusion];
            center += (extrusion.A + extrusion.B) / (2 * entries.Length);
            Half = Math.Max(Half, extrusion.Half);
        }
        // Least squares; level across a line on which all points lie.
        double xx = 1e-6, xy = 0, yy = 1e-6, xz = 0, yz = 0;
        for (var i = 0; i < 2 * entries.Length; i++)
        {
            var d = End(entries, store, i) - center;
            (xx, xy, yy, xz, yz) = (xx + d.X * d.X, xy + d.X * d.Y, yy + d.Y * d.Y, xz + d.X * d.Z, yz + d.Y * d.Z);
        }
        var determinant = xx * yy - xy * xy;
        (_riseX, _riseY) = ((yy * xz - xy * yz) / determinant, (xx * yz - xy * xz) / determinant);
        Rise = Math.Sqrt(_riseX * _riseX + _riseY * _riseY);
        var most = double.NegativeInfinity;
        for (var i = 0; i < 2 * entries.Length; i++) most = Math.Max(most, -Above(End(entries, store, i)));
        _height = most;
    }

    /// <summary>How much the plane rises for each mm; 0 = all extrusions are equally high.</summary>
    public double Rise { get; }

    /// <summary>Height of the plane above a point, mm.</summary>
    public double Above(Vec3 p) => _height + _riseX * p.X + _riseY * p.Y - p.Z;

    private static Vec3 End(ReadOnlySpan<DepositEntry> entries, ExtrusionStore store, int i)
        => i % 2 == 0 ? store[entries[i / 2].Extrusion].A : store[entries[i / 2].Extrusion].B;
}
