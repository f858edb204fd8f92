namespace Caterpillar.Toolpaths;

/// <summary>Where the tool of a tilting machine points.</summary>
/// <param name="Direction">Direction from the tip to the head at a point in mm, of any length; null = along the normals of curved layers.</param>
/// <param name="MaxTilt">Maximum lean from vertical, degrees, above 0 and at most 180. Steeper directions are limited to it.</param>
public sealed record ToolAim(Func<Vec3, Vec3>? Direction = null, double MaxTilt = 90)
{
    /// <summary>Direction across thin walls, such as their normal: where the tool would hit something it leans to one of both sides. Null = none.</summary>
    public Func<Vec3, Vec3>? Side { get; init; }

    private static readonly string[] Variables = ["x", "y", "z"];

    /// <summary>The tip points away from the nearest place of curves, mm, where the head is; or from them, if they push the head away.</summary>
    /// <param name="curves">At least one point.</param>
    /// <param name="away">The head leans away from the curves.</param>
    public static ToolAim Toward(IReadOnlyList<Polyline> curves, bool away = false)
    {
        if (curves is null) throw new ArgumentNullException(nameof(curves));
        if (!curves.Any(c => c.Count > 0)) throw new ArgumentException("There must be a point to lean to.", nameof(curves));
        return new ToolAim(p => (Nearest(p) - p) * (away ? -1 : 1));

        Vec3 Nearest(Vec3 p)
        {
            var best = curves.First(c => c.Count > 0)[0];
            foreach (var curve in curves)
            {
                for (var i = 0; i < Math.Max(curve.SegmentCount, curve.Count > 0 ? 1 : 0); i++)
                {
                    Vec3 a = curve[i], d = curve[(i + 1) % curve.Count] - a;
                    var t = d.LengthSquared > 0 ? Math.Max(0, Math.Min(1, Vec3.Dot(p - a, d) / d.LengthSquared)) : 0;
                    if (p.DistanceTo(a + d * t) < p.DistanceTo(best)) best = a + d * t;
                }
            }
            return best;
        }
    }

    /// <summary>A direction from three formulas in x, y and z (mm), such as the gradient of a field.</summary>
    /// <param name="formulas">For the three coordinates of the direction.</param>
    /// <param name="placed">Transform from the coordinates of the formulas, mm. Null = none.</param>
    /// <param name="source">Stated with errors.</param>
    public static Result<ToolAim> Formulas(IReadOnlyList<string> formulas, Affine? placed = null, SourceLocation? source = null)
    {
        if (formulas is null) throw new ArgumentNullException(nameof(formulas));
        if (formulas.Count != 3) throw new ArgumentException("A direction has three coordinates.", nameof(formulas));
        var compiled = formulas.Select(f => Formula.Compile(f, Variables, source)).ToArray();
        var problems = compiled.SelectMany(c => c.Diagnostics).ToArray();
        if (compiled[0].Value is not { } x || compiled[1].Value is not { } y || compiled[2].Value is not { } z) return new Result<ToolAim>(null, problems);
        var map = placed ?? Affine.Identity;
        var back = map.Inverse;
        return new Result<ToolAim>(new ToolAim(At), problems);

        Vec3 At(Vec3 p)
        {
            var d = back.Apply(p);
            double[] values = [d.X, d.Y, d.Z];
            return map.ApplyDirection(new Vec3(x.Evaluate(values), y.Evaluate(values), z.Evaluate(values)));
        }
    }
}
