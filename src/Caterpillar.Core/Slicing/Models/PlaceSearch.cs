namespace Caterpillar.Slicing;

/// <summary>Looks for places on a bed, one footprint after the other; those for which there is none stay null.</summary>
internal sealed class PlaceSearch(Printer printer, ArrangeOptions options, CancellationToken cancel)
{
    private const int Steps = 150;

    // Beyond, rows are looked for on the grid alone.
    private const int MaxEdges = 100;

    private readonly BedArea _bed = new(printer, options);

    /// <summary>What stands on the bed already.</summary>
    public Footprint[] Others { get; init; } = [];

    /// <summary>Each on the free point of a grid that is nearest to the middle of the bed; ties from the front left.</summary>
    public Footprint?[] FromTheMiddle(Footprint[] footprints, int[] order)
    {
        var center = printer.BuildBounds.Center.WithZ(0);
        return OnGrid(footprints, order, Grid().OrderBy(p => (p - center).LengthSquared).ThenBy(p => p.Y).ThenBy(p => p.X).ToArray());
    }

    /// <summary>Each as far in front, then as far left as it goes: beside the edges of the bed and of those that are placed, or on the grid.</summary>
    public Footprint?[] InRows(Footprint[] footprints, int[] order)
    {
        var grid = Grid();
        if (order.Length > MaxEdges) return OnGrid(footprints, order, [.. grid]);
        var placed = new Footprint?[footprints.Length];
        foreach (var i in order)
        {
            var places = grid.Concat(Corners(footprints[i], placed)).OrderBy(p => p.Y).ThenBy(p => p.X).ToArray();
            placed[i] = First(footprints[i], places, 0, placed).Found;
        }
        return placed;
    }

    /// <summary>With its middle at a place, if that is free.</summary>
    public Footprint? At(Footprint footprint, Vec3 middle) => First(footprint, [middle], 0, []).Found;

    private Footprint?[] OnGrid(Footprint[] footprints, int[] order, Vec3[] places)
    {
        var placed = new Footprint?[footprints.Length];
        // Where there is no room for a copy there is none for the next.
        var tried = new Dictionary<Footprint, int>();
        foreach (var i in order)
        {
            tried.TryGetValue(footprints[i], out var from);
            (placed[i], tried[footprints[i]]) = First(footprints[i], places, from, placed);
        }
        return placed;
    }

    private IEnumerable<Vec3> Corners(Footprint footprint, Footprint?[] placed)
    {
        var half = footprint.Box.Size * 0.5;
        // A hair more, for rounding.
        var start = printer.BuildBounds.Min + new Vec3(options.Margin + 1e-9, options.Margin + 1e-9);
        var columns = new List<double> { start.X + half.X };
        var rows = new List<double> { start.Y + half.Y };
        foreach (var other in placed)
        {
            if (other is null) continue;
            var spacing = Spacing(footprint, other) + 1e-9;
            columns.Add(other.Box.Max.X + spacing + half.X);
            rows.Add(other.Box.Max.Y + spacing + half.Y);
        }
        return rows.Distinct().SelectMany(_ => columns.Distinct(), (y, x) => new Vec3(x, y));
    }

    private List<Vec3> Grid()
    {
        var bed = printer.BuildBounds;
        var step = Math.Max(bed.Size.X, bed.Size.Y) / Steps;
        int nx = (int)(bed.Size.X / step / 2), ny = (int)(bed.Size.Y / step / 2);
        var places = new List<Vec3>();
        for (var y = -ny; y <= ny; y++)
        {
            for (var x = -nx; x <= nx; x++) places.Add(new Vec3(bed.Center.X + x * step, bed.Center.Y + y * step));
        }
        return places;
    }

    // The number of the place, too, or of all places.
    private (Footprint? Found, int Place) First(Footprint footprint, Vec3[] places, int from, Footprint?[] placed)
    {
        var middle = footprint.Box.Center;
        for (var i = from; i < places.Length; i++)
        {
            cancel.ThrowIfCancellationRequested();
            var moved = footprint.Moved(places[i].X - middle.X, places[i].Y - middle.Y);
            if (_bed.Holds(moved) && IsFree(moved, placed)) return (moved, i);
        }
        return (null, places.Length);
    }

    private bool IsFree(Footprint moved, Footprint?[] placed)
    {
        bool IsApart(Footprint? other) => other is null || moved.IsApart(other, Spacing(moved, other));
        return Array.TrueForAll(placed, IsApart) && Array.TrueForAll(Others, IsApart);
    }

    // The lower one is printed first.
    private double Spacing(Footprint a, Footprint b)
        => options.OneAfterTheOther ? Math.Max(options.Spacing, HeadClearance.Beside(printer, Math.Min(a.Height, b.Height))) : options.Spacing;
}
