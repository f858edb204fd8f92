namespace Caterpillar.Geometry;

/// <summary>
/// A rational Bézier curve of any degree with positive weights over u from 0 to 1, evaluated by de Casteljau's algorithm in homogeneous coordinates.
/// </summary>
internal sealed class BezierSpan(HomogeneousPoint[] controls)
{
    public int Degree => controls.Length - 1;

    public Vec3 Control(int i) => controls[i].Point;

    public Bounds Hull => Bounds.Of(controls.Select(c => c.Point));

    public Vec3 Point(double u)
    {
        if (u <= 0) return controls[0].Point;
        if (u >= 1) return controls[Degree].Point;
        var work = (HomogeneousPoint[])controls.Clone();
        Reduce(work, u, 0);
        return work[0].Point;
    }

    /// <summary>First and second derivative with respect to u (quotient rule on the homogeneous derivatives).</summary>
    public (Vec3 First, Vec3 Second) Derivatives(double u)
    {
        var p = Degree;
        var work = (HomogeneousPoint[])controls.Clone();
        Vec3 bend = default;
        var bendWeight = 0.0;
        if (p >= 2)
        {
            Reduce(work, u, 2);
            bend = (work[2].Weighted - 2 * work[1].Weighted + work[0].Weighted) * (p * (p - 1));
            bendWeight = (work[2].Weight - 2 * work[1].Weight + work[0].Weight) * (p * (p - 1));
            work[0] = HomogeneousPoint.Mix(work[0], work[1], u);
            work[1] = HomogeneousPoint.Mix(work[1], work[2], u);
        }
        var slope = (work[1].Weighted - work[0].Weighted) * p;
        var slopeWeight = (work[1].Weight - work[0].Weight) * p;
        var here = HomogeneousPoint.Mix(work[0], work[1], u);
        var point = here.Point;
        var first = (slope - point * slopeWeight) / here.Weight;
        return (first, (bend - first * (2 * slopeWeight) - point * bendWeight) / here.Weight);
    }

    public Vec3 StartTangent => Tangent(Enumerable.Range(1, Degree).Select(i => Control(i) - Control(0)));

    public Vec3 EndTangent => Tangent(Enumerable.Range(1, Degree).Select(i => Control(Degree) - Control(Degree - i)));

    /// <summary>True if the control points lie along the chord, in order and within a tolerance in mm; then the curve does too.</summary>
    public bool IsStraight(double tolerance)
    {
        var start = Control(0);
        var chord = Control(Degree) - start;
        var length = chord.Length;
        if (!(length > 0)) return false;
        var along = chord / length;
        var last = 0.0;
        for (var i = 1; i < Degree; i++)
        {
            var d = Control(i) - start;
            var s = Vec3.Dot(d, along);
            if (s < last - 1e-9 || s > length + 1e-9 || (d - along * s).Length > tolerance) return false;
            last = s;
        }
        return true;
    }

    /// <summary>True if all control points coincide.</summary>
    public bool IsPoint => Hull.Size.Length <= 1e-12;

    // The first of some directions that is long enough.
    private static Vec3 Tangent(IEnumerable<Vec3> directions) => directions.FirstOrDefault(d => d.Length > 1e-10).Unit();

    private void Reduce(HomogeneousPoint[] work, double u, int to)
    {
        for (var r = Degree; r > to; r--)
        {
            for (var i = 0; i < r; i++) work[i] = HomogeneousPoint.Mix(work[i], work[i + 1], u);
        }
    }
}
