namespace Caterpillar.Curved;

/// <summary>
/// A scalar field whose level sets are the layers of a print. Planar layers are the field z. The field must increase along Z everywhere, so that every layer
/// is a height field, which a vertical tool can print. Values are mm of layer thickness. Immutable and thread-safe.
/// </summary>
public abstract class LayerField
{
    /// <summary>The value at a point (mm). NaN if the field is not defined there.</summary>
    public abstract double Value(Vec3 point);

    /// <summary>The height above (x, y) at which the field has a value, mm. NaN if it has it nowhere.</summary>
    public virtual double Height(double x, double y, double value) => HeightSolver.Solve(this, x, y, value);

    /// <summary>Heights of two values over one place, mm.</summary>
    internal virtual (double First, double Second) Heights(double x, double y, double first, double second)
        => (Height(x, y, first), Height(x, y, second));

    /// <summary>False if the surfaces of the field have no height over (x, y). There the field continues beyond their edge.</summary>
    public virtual bool Covers(double x, double y) => true;

    /// <summary>Minimum feature size of the field in plan, mm. Infinite for a plane.</summary>
    public virtual double Detail => 2;

    /// <summary>True if the layers near the bed are level, so that a skirt or brim can be printed.</summary>
    public virtual bool StartsLevel => false;

    /// <summary>The upward unit normal of the layer through a point (mm).</summary>
    public virtual Vec3 Normal(Vec3 point)
    {
        const double Step = 1e-3;
        Vec3 x = new(Step, 0), y = new(0, Step), z = new(0, 0, Step);
        return new Vec3(
            ToFlat(point + x).Z - ToFlat(point - x).Z, ToFlat(point + y).Z - ToFlat(point - y).Z, ToFlat(point + z).Z - ToFlat(point - z).Z).Unit();
    }

    /// <summary>The normal of the wall at a point, if the layers are thin walls; else null.</summary>
    internal virtual Func<Vec3, Vec3>? Side => null;

    /// <summary>Maps a point of the part to the bent part with flat layers: x, y and the value of the field, mm.</summary>
    public virtual Vec3 ToFlat(Vec3 point) => point.WithZ(Value(point));

    /// <summary>Maps a point of the bent part back to the part, mm. Not finite if the part has no such point.</summary>
    public virtual Vec3 ToPart(Vec3 flat) => flat.WithZ(Height(flat.X, flat.Y, flat.Z));

    /// <summary>A point among flat layers in the part, with what an extrusion of a thickness in mm has below it.</summary>
    internal virtual LiftedPoint Lift(Vec3 flat, double thickness)
    {
        var (top, bottom) = Heights(flat.X, flat.Y, flat.Z, flat.Z - thickness);
        return new LiftedPoint(flat.WithZ(top), top - bottom, 1);
    }

    /// <summary>The part of the length of a step, mm, over which the field may change in any other than a linear manner.</summary>
    internal virtual double Span(Vec3 step) => step.Length;

    /// <summary>Values at which the field has a crease: a mesh that is bent is divided along them.</summary>
    internal virtual IReadOnlyList<double> Creases => [];

    /// <summary>Distance of layers along Z at a place, per mm of the field. 1 if unknown.</summary>
    internal virtual double Spread(Vec3 point) => 1;

    /// <summary>Whether the field moves points in plan, too.</summary>
    internal virtual bool BendsPlan => false;

    /// <summary>The settings as they suit the layers.</summary>
    internal virtual PrintSettings Suited(PrintSettings settings) => settings;

    /// <summary>A mesh bent until layers are flat, if the field was made from this mesh. Otherwise null, and it is bent point by point.</summary>
    internal virtual TriMesh? FlatMesh(TriMesh mesh) => null;

    /// <summary>The field on all of the surface that is printed as single walls; null for solids.</summary>
    internal virtual SheetField? Sheet => null;

    /// <summary>The field on the surface of one model, and how far the model was moved from there, mm. Null for solids.</summary>
    internal virtual (SheetField Field, Vec3 Shift)? SheetOf(TriMesh mesh) => null;

    /// <summary>Reports problems of the surfaces of the field.</summary>
    internal virtual void Check(DiagnosticList problems)
    {
    }

    /// <summary>The same field for a print that leaves out what it does not cover.</summary>
    internal virtual LayerField ForPartial() => this;

    /// <summary>The field for a part: constants chosen so that the part begins at the value 0 and the layers meet the surfaces of the field.</summary>
    internal virtual LayerField FitTo(PartColumns part, PrintSettings settings, DiagnosticList problems) => Anchored(this, part, settings);

    /// <summary>A field moved by whole layers, so that 0 stays a border of layers and the part is above 0.</summary>
    internal static LayerField Anchored(LayerField field, PartColumns part, PrintSettings settings)
    {
        var values = part.Columns.Select(c => field.Value(new Vec3(c.X, c.Y, c.Low)));
        var lowest = values.Where(v => !double.IsNaN(v)).DefaultIfEmpty(double.PositiveInfinity).Min();
        if (double.IsInfinity(lowest)) return field;
        const double Rounding = 1e-6;
        var layers = Math.Floor(lowest / settings.LayerHeight + Rounding);
        if (layers == 0 && lowest > -Rounding) return field;
        var shift = lowest > -Rounding ? -layers * settings.LayerHeight
            : settings.FirstLayerHeight + Math.Max(0,
                Math.Ceiling((-lowest - settings.FirstLayerHeight) / settings.LayerHeight - Rounding)) * settings.LayerHeight;
        return new ShiftedField(field, shift);
    }

    /// <summary>Layers that are copies of a plan, moved up and down. With a blend, the layers near the bed are level.</summary>
    /// <exception cref="ArgumentException">The blend does not end above its start.</exception>
    public static LayerField Vertical(PlanSurface plan, LayerBlend? blend = null)
    {
        if (plan is null) throw new ArgumentNullException(nameof(plan));
        if (blend is { } zone && !(zone.From >= 0 && zone.To > zone.From)) throw new ArgumentException("A blend must end above its start.", nameof(blend));
        return new VerticalField(plan, blend);
    }

    /// <summary>Layers at equal distances from a surface (normal offsets). The surface must be a height field.</summary>
    /// <exception cref="ArgumentException">The mesh has no triangles.</exception>
    public static LayerField Offset(TriMesh surface) => new OffsetField(surface ?? throw new ArgumentNullException(nameof(surface)));

    /// <summary>
    /// Layers of a part that is bent by a map before it is sliced flat: formulas for the bent x, y and z in x, y, z, r and theta. The paths are bent back. The
    /// map must be smooth and must not fold the part.
    /// </summary>
    /// <returns>The field, or an error with the column.</returns>
    public static Result<LayerField> Deformed(string x, string y, string z, Affine? placed = null, SourceLocation? source = null)
    {
        var compiled = new[] { FieldFormula.Compile(x, source), FieldFormula.Compile(y, source), FieldFormula.Compile(z, source) };
        var problems = compiled.SelectMany(one => one.Diagnostics).ToList();
        if (compiled[0].Value is not { } fx || compiled[1].Value is not { } fy || compiled[2].Value is not { } fz)
            return new Result<LayerField>(null, problems);
        var map = placed ?? Affine.Identity;
        var back = map.Inverse;
        return new Result<LayerField>(
            new DeformedField(p =>
            {
                var d = back.Apply(p);
                return map.Apply(new Vec3(fx.At(d.X, d.Y, d.Z), fy.At(d.X, d.Y, d.Z), fz.At(d.X, d.Y, d.Z)));
            }),
            problems);
    }

    /// <summary>Layers that divide the space between surfaces, each above the previous one.</summary>
    /// <exception cref="ArgumentException">There are fewer than two surfaces.</exception>
    public static LayerField Between(params PlanSurface[] surfaces)
    {
        if (surfaces is null) throw new ArgumentNullException(nameof(surfaces));
        if (surfaces.Length < 2) throw new ArgumentException("Layers need at least two surfaces.", nameof(surfaces));
        return new BetweenField((PlanSurface[])surfaces.Clone());
    }

    /// <summary>
    /// Level layers that bend so that gently sloped tops lie in a layer instead of in steps, for a tool that stays upright (as in CurviSlicer, Etienne and
    /// others 2019). The first layer is level; layers are no steeper than the head or <c>curved_max_slope_deg</c> allows, and no thinner or thicker than
    /// <c>curved_min_gap_mm</c> and <c>curved_max_gap_mm</c>. Where not all tops can be had, the largest are.
    /// </summary>
    /// <param name="models">The parts, on the bed.</param>
    /// <param name="setup">Print settings and printer.</param>
    /// <param name="cancel">Cancels the call.</param>
    /// <returns>The field, and notes on tops that keep their steps.</returns>
    public static Result<LayerField> Smooth(IReadOnlyList<NamedMesh> models, PrintSetup setup, CancellationToken cancel = default)
        => SmoothField.For(models ?? throw new ArgumentNullException(nameof(models)), setup ?? throw new ArgumentNullException(nameof(setup)), cancel);

    /// <summary>
    /// Layers that change as evenly as possible between the boundaries of a mesh, even at branches: a harmonic field, from Laplace's equation on the surface
    /// with cotangent weights. Its level curves are the walls; inside, layers span the walls.
    /// </summary>
    /// <param name="boundaries">Boundaries at which layers start and end.</param>
    /// <param name="cancel">Cancels the call.</param>
    public static LayerField Harmonic(MeshBoundaries boundaries, CancellationToken cancel = default)
        => BoundaryField.Of(boundaries ?? throw new ArgumentNullException(nameof(boundaries)), BoundaryField.HarmonicShares(boundaries, cancel));

    /// <summary>
    /// Layers between the boundaries of a mesh by distance along its surface (fast marching). The value is d / (d + e), with the distances d to the lower and e
    /// to the nearest upper boundary. Layers are thicker where the boundaries are farther apart. They have a crease where two upper boundaries are equally far.
    /// </summary>
    /// <inheritdoc cref="Harmonic"/>
    public static LayerField Geodesic(MeshBoundaries boundaries, CancellationToken cancel = default)
        => BoundaryField.Of(boundaries ?? throw new ArgumentNullException(nameof(boundaries)), BoundaryField.GeodesicShares(boundaries, cancel));

    /// <summary>A field from a function of the position, in mm of layer thickness. It must increase with z and be thread-safe.</summary>
    /// <param name="value">The value at a point.</param>
    /// <param name="detail">Minimum feature size, mm.</param>
    public static LayerField Of(Func<Vec3, double> value, double detail = FieldFormula.Detail)
        => new FormulaField(value ?? throw new ArgumentNullException(nameof(value)), detail);

    /// <summary>A field from a formula in x, y, z, r (mm) and theta (degrees), for example <c>z - 2 * sin(9 * x)</c>.</summary>
    /// <param name="text">The formula.</param>
    /// <param name="placed">Transform from the coordinates of the formula, mm. Null = none.</param>
    /// <param name="source">Source of the formula, for messages.</param>
    /// <returns>The field, or an error with the column.</returns>
    public static Result<LayerField> Formula(string text, Affine? placed = null, SourceLocation? source = null)
    {
        var compiled = FieldFormula.Compile(text, source);
        if (compiled.Value is not { } formula) return new Result<LayerField>(null, compiled.Diagnostics);
        var map = placed ?? Affine.Identity;
        var (back, scale) = (map.Inverse, map.ZAxis.Length);
        return new Result<LayerField>(new FormulaField(At, FieldFormula.Detail), compiled.Diagnostics);

        double At(Vec3 p)
        {
            var d = back.Apply(p);
            return scale * formula.At(d.X, d.Y, d.Z);
        }
    }

    /// <summary>The field for copies of a part as well: over each place, that of the nearest copy.</summary>
    /// <param name="copies">The part for which the field was made, and its copies, which were only moved.</param>
    /// <exception cref="ArgumentException">There is no part, or the field bends the plan.</exception>
    public LayerField ForCopies(IReadOnlyList<NamedMesh> copies)
    {
        if (copies is null) throw new ArgumentNullException(nameof(copies));
        if (copies.Count == 0 || BendsPlan) throw new ArgumentException("Copies need a part and a field that does not bend the plan.", nameof(copies));
        return copies.Count == 1 ? this : new CopiedField(this, copies);
    }
}
