namespace Caterpillar.Slicing;

// Turns of slanting rows. Where a row and its link enclose more than a right angle, the corner is round outside and leaves a wedge open up to the turn before
// it. There the row leaves its direction before its end and goes straight to the boundary, where the link begins earlier, so that it reaches into the wedge.
internal sealed partial class BoundaryLinks
{
    // In widths: how far before its end a row is left at most. Found by painting the extrusions of whole layers: little stays open, and not much more material
    // is needed than with straight ends.
    private const double Longest = 0.9;

    // Flow from the row to the boundary: row and link cover most of what lies there.
    private const double Cross = 0.5;

    // Rows that end nearly at a right angle turn without a gap.
    private const double LeastCosine = 0.17;

    // The shortest row that ends early, in lengths that it loses. Shorter ones would need too much flow to hold as much as before.
    private const double LeastRow = 20;

    // Share of the length along the boundary that the straight line to the foot must have: no turn cuts a corner.
    private const double Straight = 0.98;

    // mm along the boundary within which its direction is taken.
    private const double Near = 0.05;

    private Place[] _places = [];
    private double _width;
    private double _early;

    // Where each end lies, and how far it is from its neighbors on the contour.
    private void Distances(BoundaryIndex boundary, int count)
    {
        for (var start = 0; start < count;)
        {
            var contour = _ends[start].Contour;
            var around = boundary.Lengths[contour];
            var stop = start;
            while (stop < count && _ends[stop].Contour == contour) stop++;
            for (var i = start; i < stop; i++)
            {
                var at = _ends[i].At;
                var before = i > start ? at - _ends[i - 1].At : at - _ends[stop - 1].At + around;
                var after = i + 1 < stop ? _ends[i + 1].At - at : _ends[start].At - at + around;
                _places[_ends[i].Id] = new Place(contour, at, before, after);
            }
            start = stop;
        }
    }

    // Where the row is left, and the foot where the link begins instead of at the row's end; null where the end stays. Forward: the link follows the contour.
    private Bend? Turn(BoundaryIndex boundary, IReadOnlyList<InfillLine> lines, int id, bool forward)
    {
        if (_width == 0 && _early == 0) return null;
        var points = lines[id >> 1].Points;
        var atStart = (id & 1) == 0;
        var end = atStart ? points[0] : points[points.Length - 1];
        var inner = (atStart ? points[1] : points[points.Length - 2]) - end;
        var length = inner.LengthXY;
        if (length < Math.Max(2 * Longest * _width, LeastRow * _early)) return null;
        var place = _places[id];
        var ahead = boundary.At(place.Contour, place.At + (forward ? Near : -Near)) - end;
        var cosine = -(inner.X * ahead.X + inner.Y * ahead.Y) / (length * ahead.LengthXY);
        if (cosine <= -LeastCosine && _early > 0)
        {
            end += inner * (_early / length);
            return new Bend(end, end, place.At);
        }
        if (!(cosine >= LeastCosine) || _width == 0) return null;
        // The link stays an extrusion away from the end before it.
        var leave = Math.Min(Longest * _width, ((forward ? place.Before : place.After) - _width) / cosine);
        if (leave * Math.Sqrt(1 - Math.Min(cosine * cosine, 1)) < InfillFiller.ShortestSegment) return null;
        var reach = cosine * leave;
        var around = boundary.Lengths[place.Contour];
        var at = place.At + (forward ? -reach : reach);
        at -= Math.Floor(at / around) * around;
        var foot = boundary.At(place.Contour, at);
        if ((foot - end).LengthXY < Straight * reach) return null;
        return new Bend(end + inner * (leave / length), foot, at);
    }

    private readonly record struct Bend(Vec3 OnLine, Vec3 Foot, double At);

    private readonly record struct Place(int Contour, double At, double Before, double After);
}
