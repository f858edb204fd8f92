namespace Caterpillar.Basics;

/// <summary>
/// Trigonometry in degrees that gives the same bits on every runtime. Multiples of 30 and 90 degrees are exact if the true value is, so
/// right angles stay right. The error is below one unit in the last place.
/// </summary>
public static class Angle
{
    private const double RadiansPerDegree = Math.PI / 180;

    // π/180 = RadiansPerDegree + RadiansPerDegreeTail
    private const double RadiansPerDegreeTail = 2.9486522708701687e-19;

    private static readonly double HalfSqrt3 = Math.Sqrt(3) / 2;
    private static readonly double HalfSqrt2 = Math.Sqrt(2) / 2;

    /// <summary>Degrees to radians.</summary>
    public static double ToRadians(double degrees) => degrees * RadiansPerDegree;

    /// <summary>Radians to degrees.</summary>
    public static double ToDegrees(double radians) => radians * (180 / Math.PI);

    /// <summary>Sine and cosine of an angle in degrees. NaN for an angle that is not finite.</summary>
    public static (double Sin, double Cos) SinCos(double degrees)
    {
        var turn = Math.Abs(degrees) < 360 ? degrees : degrees % 360;
        var quadrant = (int)(double.IsNaN(turn) ? 0 : Math.Floor(turn / 90 + 0.5));
        var rest = turn - quadrant * 90.0;
        var (sin, cos) = Kernel(rest);
        return (quadrant & 3) switch
        {
            0 => (sin, cos),
            1 => (cos, Minus(sin)),
            2 => (Minus(sin), Minus(cos)),
            _ => (Minus(cos), sin),
        };
    }

    /// <summary>Sine of an angle in degrees.</summary>
    public static double Sin(double degrees) => SinCos(degrees).Sin;

    /// <summary>Cosine of an angle in degrees.</summary>
    public static double Cos(double degrees) => SinCos(degrees).Cos;

    /// <summary>Angle of the vector (x, y) from +X in degrees, −180 to 180; 0 for the zero vector.</summary>
    public static double Atan2(double y, double x)
    {
        var ax = Math.Abs(x);
        var ay = Math.Abs(y);
        if (ax == 0 && ay == 0) return 0;
        double angle;
        if (ay == 0) angle = 0;
        else if (ax == 0) angle = 90;
        else if (ax == ay) angle = 45;
        else angle = ay < ax ? ToDegrees(Math.Atan(ay / ax)) : 90 - ToDegrees(Math.Atan(ax / ay));
        if (x < 0) angle = 180 - angle;
        return y < 0 ? -angle : angle;
    }

    private static double Minus(double value) => value == 0 ? 0 : -value;

    // Taylor kernels of fdlibm on [-45°, 45°], with the tail of the product degrees × π/180.
    private static (double Sin, double Cos) Kernel(double degrees)
    {
        var size = Math.Abs(degrees);
        if (size == 30) return (degrees < 0 ? -0.5 : 0.5, HalfSqrt3);
        if (size == 45) return (degrees < 0 ? -HalfSqrt2 : HalfSqrt2, HalfSqrt2);
        var x = degrees * RadiansPerDegree;
        var tail = ProductError(degrees, RadiansPerDegree, x) + degrees * RadiansPerDegreeTail;
        var z = x * x;
        var r = 8.33333333332248946124e-03 + z * (-1.98412698298579493134e-04 + z * (2.75573137070700676789e-06
            + z * (-2.50507602534068634195e-08 + z * 1.58969099521155010221e-10)));
        var v = z * x;
        var sin = x - (z * (0.5 * tail - v * r) - tail - v * -1.66666666666666324348e-01);
        var c = z * (4.16666666666666019037e-02 + z * (-1.38888888888741095749e-03 + z * (2.48015872894767294178e-05
            + z * (-2.75573143513906633035e-07 + z * (2.08757232129817482790e-09 + z * -1.13596475577881948265e-11)))));
        var half = 0.5 * z;
        var w = 1 - half;
        var cos = w + ((1 - w - half) + (z * c - x * tail));
        return (sin, cos);
    }

    // a·b − product, exactly (Dekker).
    private static double ProductError(double a, double b, double product)
    {
        const double Split = 134217729;
        var ta = a * Split;
        var ah = ta - (ta - a);
        var al = a - ah;
        var tb = b * Split;
        var bh = tb - (tb - b);
        var bl = b - bh;
        return ((ah * bh - product) + ah * bl + al * bh) + al * bl;
    }
}
