namespace Caterpillar.Slicing;

/// <summary>Area of the bed for models: rectangle or ellipse, without the margin and the excluded areas.</summary>
internal sealed class BedArea(Printer printer, ArrangeOptions options)
{
    private readonly Bounds _bed = printer.BuildBounds;
    private readonly Footprint[] _excluded
        = printer.ExcludedAreas.Where(a => !a.IsEmpty).Select(Footprint.Of).ToArray();

    public bool Holds(Footprint footprint) => footprint.Corners.All(Holds) && !Array.Exists(_excluded, area => footprint.Separation(area) < options.Margin);

    private bool Holds(Vec3 p)
    {
        double x = p.X - _bed.Center.X, y = p.Y - _bed.Center.Y;
        double halfX = _bed.Size.X / 2 - options.Margin, halfY = _bed.Size.Y / 2 - options.Margin;
        if (printer.BedShape == BedShape.Rectangle) return Math.Abs(x) <= halfX && Math.Abs(y) <= halfY;
        return halfX > 0 && halfY > 0 && x * x / (halfX * halfX) + y * y / (halfY * halfY) <= 1;
    }
}
