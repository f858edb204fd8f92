namespace Caterpillar.Geometry;

/// <summary>The largest disc inside a region that touches its boundary at a given point: half the local thickness there.</summary>
/// <param name="Radius">mm; infinite if it is as large as was asked for, or larger.</param>
/// <param name="Contact">Where else it touches, mm.</param>
/// <param name="Edge">The edge of the contact, or the one that begins at it.</param>
/// <param name="Along">How far along the edge the contact is, 0 to 1.</param>
/// <param name="Opposite">Cosine of the angle between the directions to both contacts: −1 for parallel sides, near 1 for neighbors.</param>
internal readonly record struct InnerDisc(double Radius, Vec3 Contact, int Edge, double Along, double Opposite);

/// <summary>
/// Finds the discs of the medial axis from the boundary: for a point and its inward normal the least radius over all edges near, each by its closed form
/// (compare Ma, Bae and Choi, "3D medial axis point approximation using nearest neighbors and the normal field", 2012). No question depends on another, so
/// no input can break it.
/// </summary>
internal sealed class ThicknessProbe(SegmentGrid grid)
{
    private readonly List<int> _near = [];

    /// <param name="point">A point of the boundary.</param>
    /// <param name="normal">Unit vector to the inside.</param>
    /// <param name="edge">The edge of the point.</param>
    /// <param name="other">The other edge at it where it is a vertex, else the same.</param>
    /// <param name="limit">Maximum radius of discs that are distinguished, mm.</param>
    public InnerDisc At(Vec3 point, Vec3 normal, int edge, int other, double limit)
    {
        // What a disc of the limit can touch; the cells give some more.
        double cx = point.X + normal.X * limit, cy = point.Y + normal.Y * limit;
        grid.Near(cx - limit, cy - limit, cx + limit, cy + limit, _near);
        var best = limit;
        var found = -1;
        var along = 0.0;
        var onLine = false;
        foreach (var i in _near)
        {
            var a = grid.Points[i];
            double x = a.X - point.X, y = a.Y - point.Y;
            var ahead = x * normal.X + y * normal.Y;
            if (ahead > 1e-9)
            {
                var r = (x * x + y * y) / (2 * ahead);
                if (r < best) (best, found, along, onLine) = (r, i, 0, false);
            }
            if (i == edge || i == other) continue;
            var n = grid.Normal[i];
            // An edge that only touches the point, as where contours meet in a vertex, leaves no space for a disc.
            var height = -(x * n.X + y * n.Y);
            var slope = 1 - (n.X * normal.X + n.Y * normal.Y);
            if (height < -1e-9 || slope < 1e-9) continue;
            var radius = Math.Max(height, 0) / slope;
            if (radius >= best) continue;
            // The foot of the center on the edge; its direction is the normal turned right.
            var foot = (normal.X * radius - x) * n.Y - (normal.Y * radius - y) * n.X;
            if (foot >= 0 && foot <= grid.Length[i]) (best, found, along, onLine) = (radius, i, foot / grid.Length[i], true);
        }
        if (found < 0) return new InnerDisc(double.PositiveInfinity, point, edge, 0, 1);
        var center = point + normal * best;
        var contact = onLine ? center - grid.Normal[found] * best : grid.Points[found];
        var opposite = best > 0 ? -((contact.X - center.X) * normal.X + (contact.Y - center.Y) * normal.Y) / best : 1;
        return new InnerDisc(best, contact, found, along, opposite);
    }
}
