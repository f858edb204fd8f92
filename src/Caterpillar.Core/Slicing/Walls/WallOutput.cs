using System;
using System.Collections.Generic;
using Caterpillar.Geometry;

namespace Caterpillar.Slicing;

/// <summary>Collects walls: spacings become widths, and points that change nothing are left away.</summary>
internal sealed class WallOutput(WallRules rules)
{
    private const double WidthTolerance = 0.003;

    // Of what lies inside, where a hundredth of a millimeter is not seen.
    private const double InnerTolerance = 0.01;

    public List<WallPath> Paths { get; } = [];

    public List<ThinPlace> TooThin { get; } = [];

    public WallResult Result(Region inside) => new(Paths, inside, TooThin);

    /// <summary>Loops of one width.</summary>
    public void Loops(Region line, int index, double width, RegionEngine engine)
    {
        // Offsetting leaves corners of rounding size, which a printer need not see.
        foreach (var contour in line.Simplified(rules.Tolerance, engine).Contours)
        {
            var widths = new double[contour.Count];
            for (var i = 0; i < widths.Length; i++) widths[i] = width;
            Paths.Add(new WallPath(contour.Raw, widths, Closed: true, index, IsStrand: false));
        }
    }

    /// <summary>A loop at varying distances from the border, mm: half of what it covers.</summary>
    public void Loop(GridPoint[] ring, double[] distances, int index)
        => Add(Array.ConvertAll(ring, Grid.ToMm), Array.ConvertAll(distances, d => rules.Width(2 * d)), closed: true, index, isStrand: false);

    /// <summary>Single strands, at least as wide as a spacing.</summary>
    public void Strands(List<Strand> strands, int index, double least)
    {
        var most = Math.Max(rules.Spacing(rules.MaxWidth), rules.Spacing(rules.OuterWidth));
        foreach (var strand in strands)
        {
            if (strand.Count < 2) continue;
            var widths = new double[strand.Count];
            for (var i = 0; i < widths.Length; i++) widths[i] = rules.Width(Math.Min(Math.Max(2 * strand.Radii[i], least), most));
            Add(strand.Points, widths, strand.Closed, index, isStrand: true);
        }
    }

    private void Add(IReadOnlyList<Vec3> points, IReadOnlyList<double> widths, bool closed, int index, bool isStrand)
    {
        var (kept, keptWidths) = PathThinning.Thin(
            points, widths, closed, index == 0 && !isStrand ? rules.Tolerance : Math.Max(rules.Tolerance, InnerTolerance), WidthTolerance);
        if (kept.Length < 2 || (closed && kept.Length < 3)) return;
        Paths.Add(new WallPath(kept, keptWidths, closed, index, isStrand));
    }
}
