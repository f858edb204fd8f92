namespace Caterpillar.Slicing;

/// <summary>The course of one bead of a wall, or of a single extrusion, at Z 0.</summary>
/// <param name="Points">mm; a closed path does not repeat its first point.</param>
/// <param name="Widths">Width at each point, mm; straight in between.</param>
/// <param name="Closed">Whether it goes back to its first point.</param>
/// <param name="Index">Index of the wall from the outline. 0 = outer wall.</param>
/// <param name="IsExtrusion">Whether it fills a place too thin for a wall on each side.</param>
internal sealed record WallPath(Vec3[] Points, double[] Widths, bool Closed, int Index, bool IsExtrusion)
{
    public int SegmentCount => Closed ? Points.Length : Points.Length - 1;

    /// <summary>Volume in mm³.</summary>
    public double Volume(WallRules rules) => VolumeOf(Points, Widths, Closed, rules);

    /// <summary>Volume in mm³ of a bead along points, mm, with a width in mm at each of them.</summary>
    public static double VolumeOf(IReadOnlyList<Vec3> points, IReadOnlyList<double> widths, bool closed, WallRules rules)
    {
        var sum = 0.0;
        for (var i = closed ? 0 : 1; i < points.Count; i++)
        {
            var before = i == 0 ? points.Count - 1 : i - 1;
            sum += (rules.Area(widths[before]) + rules.Area(widths[i])) / 2 * (points[i] - points[before]).LengthXY;
        }
        return sum;
    }

    /// <summary>The same course with a volume in mm³ that is only little different: all areas change by the same share.</summary>
    public WallPath WithVolume(double volume, WallRules rules)
    {
        var own = Volume(rules);
        if (!(own > 0) || own == volume) return this;
        var share = volume / own;
        return this with { Widths = Array.ConvertAll(Widths, Scaled) };

        // Within the limits, or at least no farther out than it was.
        double Scaled(double w) => Math.Min(Math.Max(rules.Width(rules.Spacing(w) * share), Math.Min(w, rules.MinWidth)), Math.Max(w, rules.MaxWidth));
    }

    /// <summary>A piece of it, with its widths there.</summary>
    public WallPath Along(Polyline piece)
    {
        var widths = new double[piece.Count];
        for (var i = 0; i < widths.Length; i++)
        {
            var place = LoopPlace.Nearest(Points, piece[i]);
            widths[i] = Widths[place.Segment] + (Widths[place.Segment + 1 == Points.Length ? 0 : place.Segment + 1] - Widths[place.Segment]) * place.T;
        }
        return this with { Points = piece.Raw, Widths = widths, Closed = piece.IsClosed };
    }

    /// <summary>The path that prints it at a height, mm.</summary>
    public PrintPath ToPath(double z, WallRules rules) => PrintPath.Own(Array.ConvertAll(Points, p => p.WithZ(z)), Beads(rules), Closed);

    /// <summary>Beads of the segments: one for all if the width is constant, otherwise one each.</summary>
    public Bead[] Beads(WallRules rules)
    {
        if (Array.TrueForAll(Widths, width => Math.Abs(width - Widths[0]) < 1e-9)) return [new Bead(rules.Area(Widths[0]), rules.Thickness)];
        var beads = new Bead[SegmentCount];
        for (var i = 0; i < beads.Length; i++) beads[i] = new Bead(SegmentArea(i, rules), rules.Thickness);
        return beads;
    }

    private double SegmentArea(int i, WallRules rules) => (rules.Area(Widths[i]) + rules.Area(Widths[i + 1 == Widths.Length ? 0 : i + 1])) / 2;
}
