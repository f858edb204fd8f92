namespace Caterpillar.Curved;

/// <summary>
/// Layers of a part that is bent by a map of x, y and z: where the bent part has a height, the part has the layer of that value. Paths come back by Newton's
/// rule.
/// </summary>
internal sealed class DeformedField(Func<Vec3, Vec3> bend) : LayerField
{
    private const double Step = 1e-4;

    internal override bool BendsPlan => true;

    public override double Value(Vec3 point) => bend(point).Z;

    public override Vec3 ToFlat(Vec3 point) => bend(point);

    public override Vec3 ToPart(Vec3 flat) => Find(flat, flat, null).Part;

    public override double Height(double x, double y, double value) => ToPart(new Vec3(x, y, value)).Z;

    internal override LiftedPoint Lift(Vec3 flat, double thickness)
    {
        var (part, near) = Find(flat, flat, null);
        var slopes = Slopes(Find(flat.WithZ(flat.Z - thickness / 2), part, near).Part);
        var volume = thickness / Vec3.Dot(slopes.X, Vec3.Cross(slopes.Y, slopes.Z));
        var vertical = thickness / slopes.Z.Z;
        return new LiftedPoint(part, vertical, volume / vertical);
    }

    internal override LayerField FitTo(PartColumns part, PrintSettings settings, DiagnosticList problems)
    {
        foreach (var column in part.Columns)
        {
            for (var i = 0; i <= 4; i++)
            {
                var at = new Vec3(column.X, column.Y, column.Low + (column.High - column.Low) * i / 4);
                var slopes = Slopes(at);
                var determinant = Vec3.Dot(slopes.X, Vec3.Cross(slopes.Y, slopes.Z));
                if (determinant > 0 && slopes.Z.Z > 0) continue;
                problems.Add(Severity.Error, "curved.folded_deformation", $"The deformation folds the part or turns it upside down at {at}.");
                return this;
            }
        }
        return Anchored(this, part, settings);
    }

    // Slopes that are known nearby serve as long as they lead on fast.
    private (Vec3 Part, (Vec3 X, Vec3 Y, Vec3 Z)? Slopes) Find(Vec3 flat, Vec3 point, (Vec3 X, Vec3 Y, Vec3 Z)? slopes)
    {
        var rest = bend(point) - flat;
        for (var i = 0; i < 50 && rest.Length > 1e-10; i++)
        {
            if (!rest.IsFinite) break;
            var (isNew, before) = (slopes is null, rest.Length);
            var step = Solve(slopes ??= Slopes(point), rest);
            // Half steps where a whole one leads away.
            var share = 1.0;
            Vec3 next, nextRest;
            do
            {
                next = point - step * share;
                nextRest = bend(next) - flat;
                share /= 2;
            }
            while (!(nextRest.Length < rest.Length) && share > 1e-3);
            if (isNew && !(nextRest.Length < before)) break;
            if (nextRest.Length < before) (point, rest) = (next, nextRest);
            if (!(rest.Length < before / 20)) slopes = null;
        }
        return (rest.Length < 1e-6 ? point : new Vec3(double.NaN, double.NaN, double.NaN), slopes);
    }

    // Derivatives of the bent point by x, y and z.
    private (Vec3 X, Vec3 Y, Vec3 Z) Slopes(Vec3 p) => (
        (bend(p + new Vec3(Step, 0)) - bend(p - new Vec3(Step, 0))) / (2 * Step),
        (bend(p + new Vec3(0, Step)) - bend(p - new Vec3(0, Step))) / (2 * Step),
        (bend(p + new Vec3(0, 0, Step)) - bend(p - new Vec3(0, 0, Step))) / (2 * Step));

    private static Vec3 Solve((Vec3 X, Vec3 Y, Vec3 Z) m, Vec3 v)
    {
        var d = Vec3.Dot(m.X, Vec3.Cross(m.Y, m.Z));
        return new Vec3(Vec3.Dot(v, Vec3.Cross(m.Y, m.Z)) / d, Vec3.Dot(m.X, Vec3.Cross(v, m.Z)) / d, Vec3.Dot(m.X, Vec3.Cross(m.Y, v)) / d);
    }
}
