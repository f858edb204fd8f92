namespace Caterpillar.Curved;

/// <summary>Evenly spaced lines on a surface that follow directions: ribs, or infill for <see cref="CurvedOptions.InfillLines"/>.</summary>
public static class SurfaceLines
{
    /// <summary>Traces lines along a direction field.</summary>
    /// <param name="surface">The surface.</param>
    /// <param name="plan">Rectangle for the lines in x and y, mm.</param>
    /// <param name="direction">
    /// Returns the direction at a place in plan. Only X and Y count, and the sign does not matter. Lines end where it is zero or not finite.
    /// </param>
    /// <param name="spacing">Distance between lines in mm, above 0. It varies from half to twice where directions diverge or converge.</param>
    /// <param name="cancel">Cancels the call.</param>
    /// <exception cref="ArgumentOutOfRangeException">The spacing is not positive.</exception>
    /// <exception cref="OperationCanceledException">The call was canceled.</exception>
    public static IReadOnlyList<Polyline> Along(
        PlanSurface surface, Bounds plan, Func<Vec3, Vec3> direction, double spacing, CancellationToken cancel = default)
    {
        if (surface is null) throw new ArgumentNullException(nameof(surface));
        if (direction is null) throw new ArgumentNullException(nameof(direction));
        if (!(spacing > 0) || double.IsInfinity(spacing)) throw new ArgumentOutOfRangeException(nameof(spacing), "The spacing must be positive.");
        return new EvenLines(surface, plan, direction, spacing).Trace(cancel);
    }

    /// <summary>Traces lines along the principal curvatures of a surface.</summary>
    /// <param name="surface">The surface.</param>
    /// <param name="plan">Rectangle for the lines in x and y, mm.</param>
    /// <param name="spacing">Distance between lines in mm, above 0.</param>
    /// <param name="across">False = the direction of maximum curvature, true = the direction perpendicular to it.</param>
    /// <param name="cancel">Cancels the call.</param>
    /// <inheritdoc cref="Along(PlanSurface, Bounds, Func{Vec3, Vec3}, double, CancellationToken)"/>
    public static IReadOnlyList<Polyline> AlongCurvature(
        PlanSurface surface, Bounds plan, double spacing, bool across = false, CancellationToken cancel = default)
    {
        if (surface is null) throw new ArgumentNullException(nameof(surface));
        return Along(surface, plan, p => PrincipalDirection(surface, p, across), spacing, cancel);
    }

    /// <summary>Traces lines parallel to curves: each point follows the nearest curve.</summary>
    /// <param name="surface">The surface.</param>
    /// <param name="plan">Rectangle for the lines in x and y, mm.</param>
    /// <param name="curves">Curves, of which x and y count, mm; at least one of two points.</param>
    /// <param name="spacing">Distance between lines in mm, above 0.</param>
    /// <param name="cancel">Cancels the call.</param>
    /// <inheritdoc cref="Along(PlanSurface, Bounds, Func{Vec3, Vec3}, double, CancellationToken)"/>
    public static IReadOnlyList<Polyline> AlongCurves(
        PlanSurface surface, Bounds plan, IReadOnlyList<Polyline> curves, double spacing, CancellationToken cancel = default)
    {
        if (curves is null) throw new ArgumentNullException(nameof(curves));
        return Along(surface, plan, p => Nearest(curves, p), spacing, cancel);
    }

    /// <summary>
    /// The direction in plan of a principal curvature of a surface, from heights about as far around as its features are large; zero where it bends equally in
    /// all directions.
    /// </summary>
    internal static Vec3 PrincipalDirection(PlanSurface surface, Vec3 place, bool across = false)
    {
        var h = double.IsInfinity(surface.Detail) ? 1 : Math.Max(0.5, 2 * surface.Detail);
        double At(int i, int k) => surface.Height(place.X + i * h, place.Y + k * h);
        double east = At(1, 0), west = At(-1, 0), north = At(0, 1), south = At(0, -1), middle = At(0, 0);
        double zx = (east - west) / (2 * h), zy = (north - south) / (2 * h);
        double zxx = (east - 2 * middle + west) / (h * h), zyy = (north - 2 * middle + south) / (h * h);
        var zxy = (At(1, 1) - At(1, -1) - At(-1, 1) + At(-1, -1)) / (4 * h * h);
        // The shape operator: the inverse of the metric times the second derivatives.
        double e = 1 + zx * zx, f = zx * zy, g = 1 + zy * zy;
        double a = g * zxx - f * zxy, b = g * zxy - f * zyy, c = e * zxy - f * zxx, d = e * zyy - f * zxy;
        double mean = (a + d) / 2, root = Math.Sqrt(Math.Max(0, (a - d) * (a - d) / 4 + b * c));
        if (!(root > 1e-9 * (1 + Math.Abs(mean)))) return Vec3.Zero;
        var value = mean >= 0 != across ? mean + root : mean - root;
        // Of two forms of the eigenvector the longer one.
        Vec3 first = new(b, value - a), second = new(value - d, c);
        return (first.LengthSquared > second.LengthSquared ? first : second).Unit();
    }

    private static Vec3 Nearest(IReadOnlyList<Polyline> curves, Vec3 place)
    {
        // mm².
        const double Same = 1e-12;
        var (best, least) = (Vec3.Zero, double.PositiveInfinity);
        foreach (var curve in curves)
        {
            for (var i = 0; i < curve.SegmentCount; i++)
            {
                Vec3 a = curve[i].WithZ(0), d = curve[(i + 1) % curve.Count].WithZ(0) - a, p = place.WithZ(0);
                var square = d.LengthSquared;
                if (!(square > 0)) continue;
                var far = (p - a - d * Math.Min(1, Math.Max(0, Vec3.Dot(p - a, d) / square))).LengthSquared;
                // At a corner both of its sides count.
                if (far < least - Same) (best, least) = (d.Unit(), far);
                else if (far <= least + Same) best += d.Unit();
            }
        }
        return best.Unit();
    }
}
