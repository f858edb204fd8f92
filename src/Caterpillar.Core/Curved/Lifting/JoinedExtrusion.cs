namespace Caterpillar.Curved;

/// <summary>
/// An extrusion of pieces in their order, of which those that a straight line with one bead replaces closely enough are joined; the volume stays.
/// </summary>
/// <param name="tolerance">Distance of joined points from the line, mm.</param>
/// <param name="share">Greatest difference of areas and heights that are joined, in parts.</param>
/// <param name="shortest">Length up to which any of them are joined, mm.</param>
internal sealed class JoinedExtrusion(double tolerance, double share, double shortest)
{
    private const int Longest = 48;
    private readonly List<Vec3> _passed = [];
    private double _least;
    private double _most;
    private double _volume;
    private double _heights;
    private double _length;

    public List<Vec3> Points { get; } = [];

    public List<Bead> Beads { get; } = [];

    public void Clear()
    {
        Points.Clear();
        Beads.Clear();
        _passed.Clear();
    }

    /// <summary>A piece that begins where the one before ended.</summary>
    /// <param name="from">Its start, mm.</param>
    /// <param name="to">Its end, mm.</param>
    /// <param name="bead">Its bead.</param>
    /// <param name="areas">Least and greatest area that there is room for along it, mm².</param>
    /// <param name="keepsStart">It is not joined to the piece before.</param>
    /// <param name="between">Points that it passes between its ends, mm.</param>
    public void Add(Vec3 from, Vec3 to, Bead bead, (double Least, double Most) areas, bool keepsStart, params IEnumerable<Vec3> between)
    {
        var length = from.DistanceTo(to);
        if (Points.Count == 0) Points.Add(from);
        var passed = _passed.Count;
        _passed.AddRange(between);
        if (!keepsStart && Beads.Count > 0 && Fits(to, bead, areas))
        {
            _passed.Add(from);
            (_least, _most) = (Math.Min(_least, areas.Least), Math.Max(_most, areas.Most));
            (_volume, _heights, _length) = (_volume + bead.Area * length, _heights + bead.Height * length, _length + length);
            Points[Points.Count - 1] = to;
            Beads[Beads.Count - 1] = new Bead(_volume / Points[Points.Count - 2].DistanceTo(to), _heights / _length, bead.Speed);
            return;
        }
        _passed.RemoveRange(0, passed);
        (_least, _most, _volume, _heights, _length) = (areas.Least, areas.Most, bead.Area * length, bead.Height * length, length);
        Points.Add(to);
        Beads.Add(bead);
    }

    private bool Fits(Vec3 to, Bead bead, (double Least, double Most) areas)
    {
        if (_passed.Count >= Longest || bead.Speed != Beads[Beads.Count - 1].Speed) return false;
        double least = Math.Min(_least, areas.Least), most = Math.Max(_most, areas.Most);
        var start = Points[Points.Count - 2];
        if (most - least > share * most + 1e-12 && start.DistanceTo(to) > shortest) return false;
        if (bead.Height > 0 != Beads[Beads.Count - 1].Height > 0) return false;
        if (start.DistanceTo(to) <= start.DistanceTo(Points[Points.Count - 1])) return false;
        if (Points[Points.Count - 1].DistanceToSegment(start, to) > tolerance) return false;
        return _passed.TrueForAll(p => p.DistanceToSegment(start, to) <= tolerance);
    }
}
