namespace Caterpillar.Slicing;

/// <summary>
/// One round of walls of variable width. By its thickness a place gets, in beads of nominal spacing s: below 1.5 s a single extrusion; up to 2.5 s two beads
/// that share it; above that beads of s, which leave at least half a bead for the next round. So every place is full, and the outline has beads of nominal
/// width wherever it can.
/// </summary>
internal sealed class WallLevel
{
    private const double ArcTolerance = 0.005;

    // How far the two sides of a strip run past each other, so that nothing is left between them, mm.
    private const double TakeAll = 0.03;

    // Share of the thickness for two beads at which they are still laid where the place is thicker on both sides.
    private const double Tolerated = 0.88;

    private readonly WallRules _rules;
    private readonly RegionEngine _engine;
    private readonly VaryingOffset _offset;
    private readonly ExtrusionTracer _tracer;
    private readonly double _spacing;
    private readonly double _least;

    // Thickness up to which a place gets a single extrusion, and up to which two beads share it, mm.
    private readonly double _single;
    private readonly double _double;

    /// <param name="rules">Limits of the widths.</param>
    /// <param name="width">Nominal width of this round's beads, mm.</param>
    /// <param name="next">Nominal width of the next round's.</param>
    /// <param name="engine">Clips.</param>
    /// <param name="offset">Offsets strips.</param>
    public WallLevel(WallRules rules, double width, double next, RegionEngine engine, VaryingOffset offset)
    {
        _rules = rules;
        _engine = engine;
        _offset = offset;
        _spacing = rules.Spacing(width);
        _least = rules.Spacing(rules.MinWidth);
        var most = Math.Max(rules.Spacing(rules.MaxWidth), _spacing);
        _single = Math.Min(1.5 * _spacing, most);
        _double = Math.Min(2 * _spacing + Math.Max(rules.Spacing(next) / 2, _least), 2 * most);
        _tracer = new ExtrusionTracer(offset.Sampler, Math.Min(0.15, _single / 4), 0.75 * _single, _least / 2);
    }

    private double SmallestThin => 0.05 * _spacing * _spacing;

    /// <summary>Lays the loops and extrusions of this round.</summary>
    /// <param name="area">Area still to be filled, by spacings.</param>
    /// <param name="index">Number of the round.</param>
    /// <param name="output">Takes the paths.</param>
    /// <returns>What is left.</returns>
    public Region Walls(Region area, int index, WallOutput output)
    {
        var thin = ThinParts.Of(area, _double / 2, SmallestThin, _engine, out var thick);
        if (thin.IsEmpty) return Even(area, index, output);
        var wide = Extrusions(area, index, output);
        if (wide.IsEmpty) return wide;
        var strips = ReferenceEquals(wide, area) ? thin : thick.IsEmpty ? wide : wide.Subtract(thick, _engine).WithoutSmallContours(SmallestThin);
        return strips.IsEmpty ? Even(wide, index, output) : Varying(wide, strips, thick.IsEmpty, index, output);
    }

    /// <summary>Adds only the single extrusions. Returns the area that is wide enough for loops.</summary>
    public Region Extrusions(Region area, int index, WallOutput output)
    {
        // A place that is only just too thin for two beads gets two narrower ones, so that walls of nearly even thickness do not change to an extrusion and
        // back.
        var core = WithoutShort(Mitered(area, -Tolerated * _single / 2));
        var certain = ThinParts.Of(area, core, Tolerated * _single / 2, SmallestThin, _engine, out var grown);
        if (certain.IsEmpty) return area;
        core = WithoutShort(Mitered(area, -_single / 2));
        var narrow = ThinParts.Of(area, core, _single / 2, SmallestThin, _engine, out grown);
        var some = narrow.Islands.Where(piece => !piece.Intersect(certain.Near(piece.Box), _engine).IsEmpty).SelectMany(piece => piece.Paths).ToArray();
        if (some.Length < narrow.Paths.Length)
        {
            narrow = Region.Own(some);
            grown = Mitered(area.Subtract(narrow, _engine), ThinParts.Film);
        }
        // Growing back makes corners that were cut off whole again.
        var wide = grown.Intersect(area, _engine);
        var stubs = new List<GridPoint[]>();
        foreach (var piece in narrow.Islands)
        {
            // A short stub is better left to the loops.
            if (piece.Area < 0.5 * _spacing * _spacing && Touches(piece, wide)) stubs.AddRange(piece.Paths);
            else Trace(piece, index, output);
        }
        return stubs.Count == 0 ? wide : Mitered(wide, ThinParts.Film).Union(Region.Own(stubs.ToArray()), _engine).Intersect(area, _engine);
    }

    /// <summary>The single extrusions of a thin piece.</summary>
    public void Trace(Region piece, int index, WallOutput output)
    {
        var extrusions = _tracer.Trace(piece);
        new ExtrusionFinisher(piece).Finish(extrusions);
        output.Extrusions(extrusions, index, _least);
    }

    /// <summary>Lays the loops of this round with their nominal width. Returns what is left.</summary>
    public Region Even(Region area, int index, WallOutput output)
    {
        var line = area.Offset(-_spacing / 2, index == 0 ? JoinStyle.Miter : _rules.Corners, 2, WallRules.Rounding * _spacing / 2, _engine);
        output.Loops(line, index, _rules.Width(_spacing), _engine);
        return line.Offset(-_spacing / 2, _rules.Corners, 2, WallRules.Rounding * _spacing / 2, _engine);
    }

    private Region Varying(Region area, Region strips, bool all, int index, WallOutput output)
    {
        _offset.Take(area, strips, _spacing / 2, _double / 2, _least / 2);
        foreach (var (ring, distances) in _offset.Rings()) output.Loop(ring, distances, index);
        // What is left at the corners of a strip is too small for an extrusion.
        return all ? Region.Empty : _offset.Inner(TakeAll).WithoutSmallContours(0.3 * _spacing * _spacing);
    }

    private bool Touches(Region piece, Region other)
        => !piece.Offset(3 * ThinParts.Film, JoinStyle.Miter, 2, ArcTolerance, _engine).Intersect(other, _engine).IsEmpty;

    private Region Mitered(Region area, double distance) => area.Offset(distance, JoinStyle.Miter, ThinParts.MiterLimit, ArcTolerance, _engine);

    // A short thick place, such as a junction of strips, is not worth a loop.
    private Region WithoutShort(Region core)
        => core.IsEmpty ? core : Region.Own(core.Islands.Where(piece => piece.Perimeter >= 3 * _spacing).SelectMany(piece => piece.Paths).ToArray());
}
