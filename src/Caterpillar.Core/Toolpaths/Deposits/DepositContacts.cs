namespace Caterpillar.Toolpaths;

/// <summary>
/// Finds the contacts of a head and its boxes in a <see cref="Deposit"/> while they move straight from one point to another, also up or down.
/// </summary>
internal sealed class DepositContacts(DepositBins bins, DepositCells cells, ExtrusionStore store, double cell)
{
    /// <summary>
    /// The contact of the head with extrusions while its tip moves straight from a to b. Finds every contact. Dropped extrusions count as their cells.
    /// </summary>
    /// <param name="a">Start of the segment, mm.</param>
    /// <param name="b">Its end.</param>
    /// <param name="tolerance">Maximum depth of contact, mm.</param>
    /// <param name="head">The underside of the head.</param>
    /// <param name="hitsOnly">Ignore extrusions that the head only digs into.</param>
    /// <param name="tag">Tag of the extrusion that it hits or digs into. −1 = no tag.</param>
    public HeadContact Meets(Vec3 a, Vec3 b, double tolerance, HeadShape head, bool hitsOnly, out int tag)
    {
        tag = -1;
        var query = new HeadQuery(a, b, tolerance, head, hitsOnly);
        var z = Math.Min(a.Z, b.Z) + tolerance;
        var most = head.Reach(bins.Highest - z);
        if (most < 0) return HeadContact.None;
        store.BeginQuery();
        var wide = bins.SquareSide;
        var lastRow = DepositBins.SquareOf(bins.Row(Math.Max(a.Y, b.Y) + most));
        for (var tall = DepositBins.SquareOf(bins.Row(Math.Min(a.Y, b.Y) - most)); tall <= lastRow; tall++)
        {
            if (!FlatSegment.RowSpan(a, b, tall * wide - most, (tall + 1) * wide + most, out var x0, out var x1)) continue;
            var last = DepositBins.SquareOf(bins.Column(x1 + most));
            for (var broad = DepositBins.SquareOf(bins.Column(x0 - most)); broad <= last; broad++)
            {
                var reach = head.Reach(bins.TopOf(broad, tall) - z);
                if (reach < 0) continue;
                var center = new Vec3((broad + 0.5) * wide, (tall + 0.5) * wide);
                var far = reach + wide * 0.7072;
                if (FlatSegment.SquareDistance(center, a, b) > far * far) continue;
                if (MeetsIn(broad, tall, z, reach, ref query, ref tag)) return HeadContact.Hits;
            }
        }
        return query.Digs ? HeadContact.Digs : HeadContact.None;
    }

    /// <summary>
    /// True if a box that moves with its origin from a to b meets a cell more than <paramref name="tolerance"/> above its bottom. The tag is the tag of an
    /// extrusion there, or −1.
    /// </summary>
    public bool MeetsBox(Vec3 a, Vec3 b, double tolerance, Bounds box, out int tag)
    {
        tag = -1;
        var query = new BoxQuery(a, b, tolerance, box);
        var z = query.Lowest;
        if (!(bins.Highest > z)) return false;
        var firstRow = bins.Row(Math.Min(a.Y, b.Y) + box.Min.Y);
        var lastRow = bins.Row(Math.Max(a.Y, b.Y) + box.Max.Y);
        var first = bins.Column(Math.Min(a.X, b.X) + box.Min.X);
        var last = bins.Column(Math.Max(a.X, b.X) + box.Max.X);
        for (var tall = DepositBins.SquareOf(firstRow); tall <= DepositBins.SquareOf(lastRow); tall++)
        {
            for (var broad = DepositBins.SquareOf(first); broad <= DepositBins.SquareOf(last); broad++)
            {
                if (!(bins.TopOf(broad, tall) > z)) continue;
                var (rows, columns) = (DepositBins.InSquare(tall), DepositBins.InSquare(broad));
                var (rowEnd, columnEnd) = (Math.Min(lastRow, rows.Last), Math.Min(last, columns.Last));
                for (var row = Math.Max(firstRow, rows.First); row <= rowEnd; row++)
                {
                    for (var column = Math.Max(first, columns.First); column <= columnEnd; column++)
                    {
                        if (bins[column, row] is { } bin && bin.Top > z && MeetsBoxIn(bin, column, row, query, out tag)) return true;
                    }
                }
            }
        }
        return false;
    }

    // True where it hits; digging is noted in the query.
    private bool MeetsIn(int broad, int tall, double z, double most, ref HeadQuery query, ref int tag)
    {
        var side = bins.Side;
        var (a, b) = (query.From, query.To);
        var (rows, columns) = (DepositBins.InSquare(tall), DepositBins.InSquare(broad));
        var firstRow = Math.Max(rows.First, bins.Row(Math.Min(a.Y, b.Y) - most));
        var lastRow = Math.Min(rows.Last, bins.Row(Math.Max(a.Y, b.Y) + most));
        var firstColumn = Math.Max(columns.First, bins.Column(Math.Min(a.X, b.X) - most));
        var lastColumn = Math.Min(columns.Last, bins.Column(Math.Max(a.X, b.X) + most));
        for (var row = firstRow; row <= lastRow; row++)
        {
            for (var column = firstColumn; column <= lastColumn; column++)
            {
                if (bins[column, row] is not { } bin || !(bin.Top > z)) continue;
                // All of the bin is at least so far away: only what is higher than the underside of the head there can be touched.
                double x = (column + 0.5) * side, y = (row + 0.5) * side;
                var near = query.Near(x, y, side / 2, query.Head.Reach(bin.Top - z), out var away);
                var above = query.Head.HeightAt(away);
                if (!(bin.Top > z + above)) continue;
                var low = Math.Min(near.From.Z, near.To.Z) + query.Tolerance;
                if (bin.Top > low + above && MeetsBin(bin, column, row, low + above, low, near, ref query, ref tag)) return true;
            }
        }
        return false;
    }

    private bool MeetsBin(DepositBin bin, int column, int row, double z, double low, (Vec3 From, Vec3 To) near, ref HeadQuery query, ref int tag)
    {
        // Nothing in the bin is touched farther away.
        var reach = query.Head.Reach(bin.Top - low);
        var middle = new Vec3((column + 0.5) * bins.Side, (row + 0.5) * bins.Side);
        for (var block = (bin.Count - 1) >> DepositBin.BlockBits; block >= 0; block--)
        {
            var first = block << DepositBin.BlockBits;
            if (first + DepositBin.Block <= bin.Count)
            {
                if (!(bin.BoundsOf(block).TopSoFar > z)) break;
                ref var bounds = ref bin.WithPlane(block, middle, bins.Side / 2 + cell, store);
                if (!query.MayMeet(bounds, near, bin.Top - low)) break;
                if (!(bounds.Top > z)) continue;
            }
            for (var i = Math.Min(first + DepositBin.Block, bin.Count) - 1; i >= first; i--)
            {
                if (!(bin.Entries[i].Top > z)) continue;
                ref var extrusion = ref store[bin.Entries[i].Extrusion];
                // All of it is looked at, once for all bins.
                if (extrusion.IsBeyond(query.From, query.To, reach + extrusion.Half) || !store.IsNew(bin.Entries[i].Extrusion)) continue;
                var hits = query.Meets(extrusion);
                if (hits || (query.Digs && tag < 0)) tag = extrusion.Tag;
                if (hits) return true;
            }
        }
        if (!(bin.Dropped > z)) return false;
        for (var i = 0; i < DepositBin.Cells; i++)
        {
            var top = Math.Min(cells.InBin(column, row, i).Top, bin.Dropped);
            var center = DepositCells.Center(column, row, i, cell).WithZ(top);
            if (!(top > z) || !query.Meets(Extrusion.Of(center, center, cell * 0.7072))) continue;
            tag = -1;
            return true;
        }
        return false;
    }

    private bool MeetsBoxIn(DepositBin bin, int column, int row, in BoxQuery query, out int tag)
    {
        tag = -1;
        var z = query.LowestOver(new Vec3((column + 0.5) * bins.Side, (row + 0.5) * bins.Side), bins.Side / 2);
        if (!(bin.Top > z)) return false;
        for (var i = 0; i < DepositBin.Cells; i++)
        {
            var top = cells.InBin(column, row, i).Top;
            if (!(top > z) || !(top > query.LowestOver(DepositCells.Center(column, row, i, cell), cell / 2))) continue;
            for (var k = bin.Count - 1; k >= 0 && tag < 0; k--)
            {
                if (bin.Entries[k].Top > z) tag = store[bin.Entries[k].Extrusion].Tag;
            }
            return true;
        }
        return false;
    }
}
