namespace Caterpillar.Toolpaths;

/// <summary>Tells what of a <see cref="Deposit"/> is in the place of a new extrusion.</summary>
internal sealed class DepositOverlaps(DepositBins bins, DepositCells cells, ExtrusionStore store, double cell)
{
    // Extrusions that are looked at, of those that were added last.
    private const int MostParallel = 128;

    // mm; far more than an interpolated height is off.
    private const double Rounding = 1e-6;

    // Cosine of 18°.
    private const double Parallel = 0.95;
    private readonly double _perCell = 1 / cell;

    /// <summary>
    /// Of the last extrusions around a point of a new one: one along it, about as high and as wide, with the axes less than a quarter of their widths apart; or
    /// a solid one at the point, with a gap above it.
    /// </summary>
    /// <param name="p">The point.</param>
    /// <param name="along">Direction of the new extrusion there.</param>
    /// <param name="half">Half its width, mm.</param>
    /// <param name="height">Its height, mm.</param>
    /// <param name="gap">Smallest and largest gap above solid extrusions, mm.</param>
    /// <param name="solid">Extrusions with a lower tag are solid.</param>
    /// <param name="tag">Tag of the other extrusion. −1 = none.</param>
    public DepositOverlap At(Vec3 p, Vec3 along, double half, double height, (double Least, double Most) gap, int solid, out int tag)
    {
        tag = -1;
        var found = DepositOverlap.None;
        if (!bins.MayHold(p.X, p.Y)) return found;
        int column = ExtrusionRows.Index(p.X, _perCell), row = ExtrusionRows.Index(p.Y, _perCell);
        double lowest = p.Z - 0.5 * height - Rounding, lowestSolid = p.Z - gap.Most;
        // An extrusion in its place would have raised the cell.
        if (cells[column, row].Top < Math.Min(lowest, lowestSolid)) return found;
        if (bins[column >> DepositBin.Bits, row >> DepositBin.Bits] is not { } bin) return found;
        var length = along.LengthXY;
        if (!(length > 0)) return found;
        for (int i = bin.Count - 1, last = Math.Max(0, bin.Count - MostParallel); i >= last; i--)
        {
            var top = bin.Entries[i].Top;
            // The layer below begins here.
            if (top < p.Z - 2 * height && top < lowestSolid) return found;
            if (top < lowest && top < lowestSolid) continue;
            ref var extrusion = ref store[bin.Entries[i].Extrusion];
            if (extrusion.Tag < solid && found == DepositOverlap.None)
            {
                var there = extrusion.TopAt(p, 0);
                if (there >= lowestSolid && there <= p.Z - gap.Least) (found, tag) = (DepositOverlap.Solid, extrusion.Tag);
            }
            if (top < lowest || Math.Min(half, extrusion.Half) < 0.6 * Math.Max(half, extrusion.Half)) continue;
            double dx = extrusion.Bx - extrusion.Ax, dy = extrusion.By - extrusion.Ay;
            var near = 0.25 * (half + extrusion.Half);
            // Most are clearly beside it, which is told without a root.
            var aside = (p.X - extrusion.Ax) * dy - (p.Y - extrusion.Ay) * dx;
            if (aside * aside > (near * near + Rounding) * (dx * dx + dy * dy)) continue;
            var other = Math.Sqrt(dx * dx + dy * dy);
            if (!(other > 0) || Math.Abs(dx * along.X + dy * along.Y) < Parallel * other * length) continue;
            var t = ((p.X - extrusion.Ax) * dx + (p.Y - extrusion.Ay) * dy) / (other * other);
            if (t < 0 || t > 1) continue;
            double ex = p.X - extrusion.Ax - dx * t, ey = p.Y - extrusion.Ay - dy * t;
            if (ex * ex + ey * ey > near * near || Math.Abs(extrusion.Az + (extrusion.Bz - extrusion.Az) * t - p.Z) > 0.5 * height) continue;
            tag = extrusion.Tag;
            return found | DepositOverlap.Parallel;
        }
        return found;
    }
}

/// <summary>What is in the place of a new extrusion.</summary>
[Flags]
internal enum DepositOverlap
{
    None = 0,

    /// <summary>An extrusion along it.</summary>
    Parallel = 1,

    /// <summary>One that is solid.</summary>
    Solid = 2,
}
