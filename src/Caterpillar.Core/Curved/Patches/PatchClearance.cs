namespace Caterpillar.Curved;

/// <summary>Whether a head that prints one patch goes through another that is printed already, cell by cell.</summary>
/// <param name="printer">Nozzle, head and gantry.</param>
/// <param name="cell">Side of the cells of patches, mm.</param>
/// <param name="slack">How much nearer than the middles of their cells points may be to each other, mm.</param>
internal sealed class PatchClearance(Printer printer, double cell, double slack)
{
    // Rise that an extrusion beside the nozzle may have, mm.
    private const double Flush = 0.1;
    private readonly HeadShape _shape = new(printer.HeadOutline.Select(p => (p.Radius, p.Height)));

    // Below this nothing but nozzle and cone is met.
    private readonly double _boxes = printer.HeadBoxes.Concat(printer.Gantry).Select(b => b.Min.Z).DefaultIfEmpty(double.PositiveInfinity).Min();

    /// <summary>True if the print head hits one printed patch while it prints another.</summary>
    public bool IsBlocked(LayerPatch printed, LayerPatch next)
    {
        if (!MayMeet(printed.Box, printed.Box.Max.Z, next.Box)) return false;
        foreach (var from in printed.Cells)
        {
            if (!MayMeet(Bounds.Empty.Include(new Vec3(from.Column, from.Row)), from.Top, next.Box)) continue;
            foreach (var to in next.Cells)
            {
                if (Meets((from.Column - to.Column) * cell, (from.Row - to.Row) * cell, from.Top - to.Low - Flush)) return true;
            }
        }
        return false;
    }

    private bool Meets(double x, double y, double rise)
    {
        if (!(rise > 0)) return false;
        if (rise > _shape.HeightAt(Math.Sqrt(x * x + y * y) - slack)) return true;
        if (!(rise > _boxes)) return false;
        foreach (var box in printer.HeadBoxes.Concat(printer.Beams(double.PositiveInfinity)))
        {
            if (rise > box.Min.Z && x > box.Min.X - slack && x < box.Max.X + slack && y > box.Min.Y - slack && y < box.Max.Y + slack) return true;
        }
        return false;
    }

    // Columns and rows of what is printed, how high it reaches, and the box of what comes next.
    private bool MayMeet(Bounds printed, double top, Bounds next)
    {
        var x = Math.Max(printed.Min.X - next.Max.X, next.Min.X - printed.Max.X);
        var y = Math.Max(printed.Min.Y - next.Max.Y, next.Min.Y - printed.Max.Y);
        var distance = new Vec3(Math.Max(0, x), Math.Max(0, y)).LengthXY * cell - slack;
        return top - next.Min.Z > Math.Min(_boxes, _shape.HeightAt(distance)) + Flush;
    }
}
