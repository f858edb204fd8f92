namespace Caterpillar.Curved;

/// <summary>Finds the height at which a rising field has a value: a bracket that grows until it holds it, then secants kept inside the bracket.</summary>
internal static class HeightSolver
{
    // mm.
    private const double Exact = 1e-10;
    private const double Farthest = 1e5;

    /// <summary>The height in mm; NaN if the field has no value there, or never this one.</summary>
    public static double Solve(LayerField field, double x, double y, double value)
    {
        double At(double z) => field.Value(new Vec3(x, y, z)) - value;

        var low = value;
        var atLow = At(low);
        if (atLow == 0) return low;
        var step = Math.Max(1, Math.Abs(atLow));
        var up = atLow < 0;
        var (high, atHigh) = (low, atLow);
        while (atHigh < 0 == up)
        {
            (low, atLow) = (high, atHigh);
            high += up ? step : -step;
            atHigh = At(high);
            if (atHigh == 0) return high;
            step *= 2;
            if (!(Math.Abs(high) < Farthest) || double.IsNaN(atHigh)) return double.NaN;
        }
        // The sign of the value differs at the ends; the Illinois rule keeps both of them moving.
        var side = 0;
        for (var i = 0; i < 200 && Math.Abs(high - low) > Exact; i++)
        {
            var z = i % 8 == 7 ? (low + high) / 2 : (low * atHigh - high * atLow) / (atHigh - atLow);
            var at = At(z);
            if (at == 0) return z;
            if (double.IsNaN(at)) return double.NaN;
            if (at < 0 == atLow < 0)
            {
                if (Math.Abs(z - low) < Exact / 2) return z;
                (low, atLow) = (z, at);
                if (side == -1) atHigh /= 2;
                side = -1;
            }
            else
            {
                if (Math.Abs(z - high) < Exact / 2) return z;
                (high, atHigh) = (z, at);
                if (side == 1) atLow /= 2;
                side = 1;
            }
        }
        return Math.Abs(atLow) < Math.Abs(atHigh) ? low : high;
    }
}
