namespace Caterpillar.Geometry;

/// <summary>
/// Drops vertices of closed paths in one pass: from a kept vertex the chord grows as long as it stays within the tolerance of every vertex it passes,
/// which is the intersection of the wedges in which these vertices' discs are seen (sleeve fitting: Zhao and Saalfeld, "Linear-time sleeve-fitting
/// polyline simplification algorithms", 1997). It starts at the leftmost vertex, so the result does not depend on where the path starts.
/// </summary>
internal sealed class ContourSimplifier
{
    public GridPoint[] Points { get; private set; } = new GridPoint[256];

    public int Count { get; private set; }

    /// <summary>Simplifies a path with a tolerance in grid units, into <see cref="Points"/>.</summary>
    public void Simplify(GridPoint[] path, double tolerance)
    {
        var n = path.Length;
        if (Points.Length < n) Points = new GridPoint[Math.Max(n, 2 * Points.Length)];
        Count = 0;
        if (n == 0) return;
        var start = Leftmost(path);
        var square = tolerance * tolerance;
        // Steps from the start to the kept vertex and to its successor.
        for (int kept = 0, step = 1; kept < n; kept = step, step = kept + 1)
        {
            var a = path[At(start + kept, n)];
            Points[Count++] = a;
            double lowX = 0, lowY = 0, highX = 0, highY = 0, farthest = 0;
            for (; step <= n; step++)
            {
                var b = path[At(start + step, n)];
                double x = (double)b.X - a.X, y = (double)b.Y - a.Y;
                var distance = x * x + y * y;
                if (farthest > 0)
                {
                    // Outside the wedge, or going back: the chord ends one vertex before.
                    if (distance < farthest || lowX * y - lowY * x < 0 || highX * y - highY * x > 0) break;
                }
                if (distance <= square) continue;
                var w = tolerance / Math.Sqrt(distance);
                double lx = x + y * w, ly = y - x * w, hx = x - y * w, hy = y + x * w;
                if (farthest == 0 || lowX * ly - lowY * lx > 0) (lowX, lowY) = (lx, ly);
                if (farthest == 0 || highX * hy - highY * hx < 0) (highX, highY) = (hx, hy);
                farthest = distance;
            }
            // The loop stopped at a vertex that can't be reached, or after the last; the one before it ends the chord.
            step = Math.Max(step - 1, kept + 1);
        }
    }

    private static int At(int index, int n) => index < n ? index : index < 2 * n ? index - n : index - 2 * n;

    private static int Leftmost(GridPoint[] path)
    {
        var best = 0;
        for (var i = 1; i < path.Length; i++)
        {
            if (path[i].X < path[best].X || (path[i].X == path[best].X && path[i].Y < path[best].Y)) best = i;
        }
        return best;
    }
}
