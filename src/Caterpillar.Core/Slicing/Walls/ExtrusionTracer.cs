namespace Caterpillar.Slicing;

/// <summary>
/// The medial axis of thin places as single extrusions. Going along a contour, the centers of the discs go along the axis, past both sides of every branch.
/// Each disc touches two places; the one that comes first in the order of the contours owns its center, so that each branch comes once.
/// </summary>
internal sealed class ExtrusionTracer(BoundarySampler sampler, double step, double limit, double thinnest)
{
    // Sides that open by more than this (cosine of the angle between contacts) are a corner and no strip.
    private const double Corner = -0.26;

    // Of each contour; used again for the next piece.
    private readonly List<List<BoundarySample>> _samples = [];

    private enum State : byte { Unknown, Owned, Elsewhere, Thin }

    public List<MedialExtrusion> Trace(Region piece)
    {
        sampler.Aim(piece, null, step, limit);
        var grid = sampler.Edges;
        var contours = grid.Contours;
        while (_samples.Count < contours) _samples.Add([]);
        var first = new double[contours];
        var start = new int[contours];
        for (var c = 0; c < contours; c++)
        {
            var samples = _samples[c];
            sampler.Take(c, samples);
            // Begins at a corner, which is an end of the axis: from there the branches nest.
            start[c] = Math.Max(0, samples.FindIndex(s => s.Disc.Radius == 0 || s.Disc.Opposite > Corner));
            first[c] = samples.Count == 0 ? 0 : samples[start[c]].Edge + samples[start[c]].Along;
        }
        var extrusions = new List<MedialExtrusion>();
        for (var c = 0; c < contours; c++) Runs(grid, _samples[c], start[c], first, extrusions);
        if (extrusions.Count == 0) Dot(contours, extrusions);
        return extrusions;
    }

    // A piece that is as wide as long has no strip: one dot at its thickest.
    private void Dot(int contours, List<MedialExtrusion> extrusions)
    {
        var largest = 0.0;
        var center = Vec3.Zero;
        foreach (var contour in _samples.Take(contours))
        {
            foreach (var sample in contour)
            {
                var radius = Math.Min(sample.Disc.Radius, limit);
                if (radius > largest + 1e-6) (largest, center) = (radius, sample.Point + sample.Normal * radius);
            }
        }
        if (2 * largest < thinnest) return;
        var dot = new MedialExtrusion();
        dot.Add(center, largest);
        extrusions.Add(dot);
    }

    private void Runs(SegmentGrid grid, List<BoundarySample> samples, int start, double[] first, List<MedialExtrusion> extrusions)
    {
        MedialExtrusion? open = null;
        var before = extrusions.Count;
        var gap = false;
        var ownedFirst = false;
        var known = false;
        var last = State.Unknown;
        for (var k = 0; k < samples.Count; k++)
        {
            var sample = samples[(start + k) % samples.Count];
            var state = StateOf(grid, sample, first);
            if (state == State.Unknown)
            {
                gap = true;
                continue;
            }
            if (!known) ownedFirst = state == State.Owned;
            known = true;
            if (state == State.Owned)
            {
                var radius = Math.Min(sample.Disc.Radius, limit);
                var center = sample.Point + sample.Normal * radius;
                if (open is not null && gap && (center - open.Points[open.Count - 1]).LengthXY > 2 * (radius + open.Radii[open.Count - 1]))
                {
                    open.End = ExtrusionEnd.Outline;
                    open = null;
                }
                if (open is null)
                {
                    var ran = last == State.Thin && radius < thinnest ? ExtrusionEnd.Thin : ExtrusionEnd.Junction;
                    open = new MedialExtrusion { Start = gap || k == 0 ? ExtrusionEnd.Outline : ran };
                    extrusions.Add(open);
                }
                if (open.Count == 0 || (center - open.Points[open.Count - 1]).LengthXY > 1e-4) open.Add(center, radius);
            }
            else
            {
                // Thin where it ran out in thinness, rather than at a step.
                var isThin = state == State.Thin && open?.Radii[open.Count - 1] < thinnest;
                if (open is not null) open.End = gap ? ExtrusionEnd.Outline : isThin ? ExtrusionEnd.Thin : ExtrusionEnd.Junction;
                open = null;
            }
            gap = false;
            last = state;
        }
        if (open is null) return;
        open.End = ExtrusionEnd.Outline;
        // Past the beginning of the contour it may go on.
        var head = extrusions[before];
        if (!ownedFirst || open.Count < 3 || (open.Points[open.Count - 1] - head.Points[0]).LengthXY > 2 * (head.Radii[0] + open.Radii[open.Count - 1])) return;
        if (head == open)
        {
            open.Closed = true;
            return;
        }
        for (var i = 0; i < head.Count; i++) open.Add(head.Points[i], head.Radii[i]);
        open.End = head.End;
        extrusions.RemoveAt(before);
    }

    private State StateOf(SegmentGrid grid, in BoundarySample sample, double[] first)
    {
        if (double.IsInfinity(sample.Disc.Radius) || sample.Disc.Opposite > Corner) return State.Unknown;
        if (2 * sample.Disc.Radius < thinnest) return State.Thin;
        int own = grid.Contour[sample.Edge], other = grid.Contour[sample.Disc.Edge];
        if (own != other) return own < other ? State.Owned : State.Elsewhere;
        var here = Order(grid, own, sample.Edge + sample.Along, first);
        var there = Order(grid, own, sample.Disc.Edge + sample.Disc.Along, first);
        return here < there ? State.Owned : State.Elsewhere;
    }

    private static double Order(SegmentGrid grid, int contour, double place, double[] first)
    {
        var order = place - first[contour];
        return order < 0 ? order + (grid.ContourStart[contour + 1] - grid.ContourStart[contour]) : order;
    }
}
