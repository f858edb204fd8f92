namespace Caterpillar.Curved;

/// <summary>A surface that layers follow: one height for each (x, y), mm. Immutable and thread-safe.</summary>
public abstract class PlanSurface
{
    /// <summary>What else there is for a part whose top is no surface that layers can follow.</summary>
    internal const string Otherwise = " If it is the top of the part, smooth layers (--field smooth) find by themselves what can be followed.";

    private protected PlanSurface()
    {
    }

    /// <summary>Height over (x, y), mm. It continues beyond the edge of the surface, where <see cref="Covers"/> is false.</summary>
    public abstract double Height(double x, double y);

    /// <summary>True if the surface has a height over (x, y).</summary>
    public virtual bool Covers(double x, double y) => true;

    /// <summary>Minimum feature size, mm. Infinite for a plane.</summary>
    public virtual double Detail => double.PositiveInfinity;

    /// <summary>How the height changes with x and with y at a place.</summary>
    internal virtual (double ByX, double ByY) Slope(double x, double y)
    {
        const double Step = 1e-4;
        var height = Height(x, y);
        return ((Height(x + Step, y) - height) / Step, (Height(x, y + Step) - height) / Step);
    }

    /// <summary>True for a level plane.</summary>
    internal virtual bool IsLevel => false;

    /// <summary>Reports problems of the surface: folded, upside down, no faces.</summary>
    internal virtual void Check(DiagnosticList problems)
    {
    }

    /// <summary>The surface moved by a vector, mm.</summary>
    public PlanSurface Moved(Vec3 shift) => Transformed(Affine.Move(shift));

    /// <summary>The surface after a transform that keeps vertical lines vertical.</summary>
    /// <exception cref="ArgumentException">The transform tilts the surface or is singular.</exception>
    public PlanSurface Transformed(Affine map)
    {
        if (!map.IsUpright || map.Determinant == 0) throw new ArgumentException("A surface of heights cannot be tilted.", nameof(map));
        return map == Affine.Identity ? this : new TransformedPlan(this, map);
    }

    /// <summary>A level plane at a height in mm.</summary>
    public static PlanSurface Level(double height) => new FunctionPlan((_, _) => height, double.PositiveInfinity, level: true);

    /// <summary>A surface from a function of x and y, mm.</summary>
    /// <param name="height">Height in mm. The function must be thread-safe.</param>
    /// <param name="detail">Minimum feature size, mm. Infinite for a plane.</param>
    public static PlanSurface Of(Func<double, double, double> height, double detail = double.PositiveInfinity)
        => new FunctionPlan(height ?? throw new ArgumentNullException(nameof(height)), detail);

    /// <summary>The top faces of a mesh: an open surface, or the top of a solid such as a scanned object.</summary>
    public static PlanSurface Of(TriMesh mesh) => new MeshPlan(mesh ?? throw new ArgumentNullException(nameof(mesh)));

    /// <summary>The top of an object on the bed, and the bed around it.</summary>
    public static PlanSurface OnBed(TriMesh mesh)
    {
        var surface = Of(mesh);
        return Of((x, y) => surface.Covers(x, y) ? Math.Max(0, surface.Height(x, y)) : 0, surface.Detail);
    }

    /// <summary>A surface from a formula in x, y, r (mm) and theta (degrees), for example <c>10 + 2 * sin(9 * x)</c>.</summary>
    /// <returns>The surface, or an error with the column.</returns>
    public static Result<PlanSurface> Formula(string text, SourceLocation? source = null)
    {
        var compiled = FieldFormula.Compile(text, source);
        if (compiled.Value is not { } formula) return new Result<PlanSurface>(null, compiled.Diagnostics);
        var detail = formula.IsConstant ? double.PositiveInfinity : FieldFormula.Detail;
        return new Result<PlanSurface>(new FunctionPlan((x, y) => formula.At(x, y, 0), detail), compiled.Diagnostics);
    }

    /// <summary>A cone about a vertical axis. Layers descend outward by an angle, or rise if it is negative.</summary>
    /// <param name="axis">A point of the axis, mm.</param>
    /// <param name="degrees">Angle, −80 to 80 degrees.</param>
    /// <exception cref="ArgumentOutOfRangeException">The angle is out of range.</exception>
    public static PlanSurface Cone(Vec3 axis, double degrees)
    {
        if (!(Math.Abs(degrees) <= 80)) throw new ArgumentOutOfRangeException(nameof(degrees), "The angle of a cone must be at most 80 degrees.");
        var (sin, cos) = Angle.SinCos(degrees);
        return Of((x, y) => -sin / cos * Math.Sqrt((x - axis.X) * (x - axis.X) + (y - axis.Y) * (y - axis.Y)), 5);
    }

    /// <summary>A surface that descends with the distance from the footprint of the parts, so that overhangs rest on earlier layers.</summary>
    /// <param name="models">The parts, on the bed.</param>
    /// <param name="setup">Print settings and printer. The print head limits the angle.</param>
    /// <param name="degrees">Angle of the layers in degrees. Null = the minimum angle at which all overhangs are at least 45 degrees steep.</param>
    /// <returns>The surface, or an error if no part touches the bed.</returns>
    public static Result<PlanSurface> AgainstOverhangs(IReadOnlyList<NamedMesh> models, PrintSetup setup, double? degrees = null)
        => OverhangPlan.For(models ?? throw new ArgumentNullException(nameof(models)), setup ?? throw new ArgumentNullException(nameof(setup)), degrees);

    /// <summary>A height map: an image over a rectangle, black lowest and white highest, interpolated between pixel centers (bilinear).</summary>
    /// <param name="image">Image whose brightness is the height.</param>
    /// <param name="box">Position of the image in x and y, and heights of black and white in z, mm.</param>
    /// <exception cref="ArgumentException">The box has no area.</exception>
    public static PlanSurface HeightMap(GrayImage image, Bounds box) => new ImagePlan(image, box);

    private sealed class FunctionPlan(Func<double, double, double> height, double detail, bool level = false) : PlanSurface
    {
        internal override bool IsLevel => level;

        public override double Detail => detail;

        public override double Height(double x, double y) => height(x, y);
    }
}
