namespace Caterpillar.Machines;

/// <summary>A point of an infill curve.</summary>
/// <param name="Curve">Number of the curve. Consecutive points with the same number form one curve.</param>
/// <param name="X">mm.</param>
/// <param name="Y">mm.</param>
public readonly record struct InfillPoint(int Curve, double X, double Y)
{
    /// <summary>The points of curves, seen from above. Closed curves end at their start point.</summary>
    public static ValueList<InfillPoint> Of(IEnumerable<Polyline> curves)
    {
        if (curves is null) throw new ArgumentNullException(nameof(curves));
        var points = new List<InfillPoint>();
        var number = 0;
        foreach (var curve in curves)
        {
            for (var i = 0; i < curve.Count; i++) points.Add(new InfillPoint(number, curve[i].X, curve[i].Y));
            if (curve.IsClosed) points.Add(new InfillPoint(number, curve[0].X, curve[0].Y));
            number++;
        }
        return new ValueList<InfillPoint>(points);
    }

    /// <summary>The curves of points, at Z 0.</summary>
    public static IReadOnlyList<Polyline> Curves(ValueList<InfillPoint> points)
    {
        if (points is null) throw new ArgumentNullException(nameof(points));
        var curves = new List<Polyline>();
        var run = new List<Vec3>();
        for (var i = 0; i < points.Count; i++)
        {
            run.Add(new Vec3(points[i].X, points[i].Y));
            if (i + 1 < points.Count && points[i + 1].Curve == points[i].Curve) continue;
            var closed = run.Count > 3 && run[0] == run[run.Count - 1];
            if (closed) run.RemoveAt(run.Count - 1);
            if (run.Count > 1) curves.Add(new Polyline(run, closed));
            run.Clear();
        }
        return curves;
    }

    internal static InfillPoint? Of(double[] n) => n[0] == Math.Floor(n[0]) ? new InfillPoint((int)n[0], n[1], n[2]) : null;
}
