namespace Caterpillar.Slicing;

/// <summary>Parts of a loop over air. A seam there would be a free end that sags.</summary>
internal sealed class LoopSupport(List<(double From, double To)> air, double whole, double over)
{
    // mm that a seam keeps from the air, where there is so much.
    private const double Margin = 1;

    /// <summary>Supported fraction of the loop, 0 to 1.</summary>
    public double Share => 1 - over / whole;

    /// <summary>True if the whole loop is over air.</summary>
    public bool IsNowhere => over > whole - 1e-6;

    /// <summary>The parts of a loop, or null where all of it is supported.</summary>
    /// <param name="loop">The loop.</param>
    /// <param name="below">Cuts lines to their parts outside the layer below.</param>
    public static LoopSupport? Of(Vec3[] loop, LineClipper below)
    {
        var air = new List<(double From, double To)>();
        var parts = new List<(double From, double To)>();
        double done = 0, over = 0;
        below.Follow(loop);
        for (var i = 0; i < loop.Length; i++)
        {
            Vec3 a = loop[i], b = loop[i + 1 == loop.Length ? 0 : i + 1];
            var length = (b - a).LengthXY;
            parts.Clear();
            if (length > 0) below.Parts(i, parts);
            foreach (var (from, to) in parts)
            {
                var start = done + from * length;
                over += (to - from) * length;
                if (air.Count > 0 && start - air[air.Count - 1].To < 1e-6) air[air.Count - 1] = (air[air.Count - 1].From, done + to * length);
                else air.Add((start, done + to * length));
            }
            done += length;
        }
        return air.Count == 0 ? null : new LoopSupport(air, done, over);
    }

    /// <summary>The place nearest to another, along the loop, from which the extrusion lies on something on both sides.</summary>
    public LoopPlace Near(Vec3[] loop, LoopPlace wanted)
    {
        if (IsNowhere) return wanted;
        var at = wanted.T * (loop[wanted.Segment + 1 == loop.Length ? 0 : wanted.Segment + 1] - loop[wanted.Segment]).LengthXY;
        for (var i = 0; i < wanted.Segment; i++) at += (loop[i + 1] - loop[i]).LengthXY;
        double best = at, bestMargin = -1, bestMoved = 0;
        for (var i = 0; i < air.Count; i++)
        {
            // From the end of one part in the air to the beginning of the next.
            var from = air[i].To;
            var length = (i + 1 < air.Count ? air[i + 1].From : air[0].From + whole) - from;
            var margin = Math.Min(Margin, length / 2);
            var place = at < from ? at + whole : at;
            if (place > from + length - margin)
            {
                // The nearer end, around the loop.
                var past = place - (from + length - margin);
                var before = from + whole + margin - place;
                place = past <= before ? from + length - margin : from + margin;
            }
            else if (place < from + margin)
            {
                place = from + margin;
            }
            var moved = Math.Abs(place - at) % whole;
            moved = Math.Min(moved, whole - moved);
            if (margin < bestMargin || (margin == bestMargin && moved >= bestMoved)) continue;
            (best, bestMargin, bestMoved) = (place, margin, moved);
        }
        return bestMoved < 1e-6 ? wanted : LoopPlace.AtLength(loop, best % whole);
    }
}
