namespace Caterpillar.Curved;

/// <summary>
/// A field whose flat layers are as wide as the layers are along themselves, so that walls and lines keep their distance on slopes. The plan is stretched along
/// the two main directions of the slopes, at each position by the root mean square of what the slopes there ask for: exact for tilted planes, waves and roofs
/// that slope in one direction, and near to it for others. Amounts are reduced by as much as the plan grows.
/// </summary>
internal sealed class StretchedField(LayerField inner, SlopeSamples samples) : WrappedField(inner)
{
    // Nodes along each axis, and levels of the field, between which the stretch is linear.
    private const int Nodes = 33;
    private const int Levels = 17;

    // Less would not be seen in print: slopes below 2.5 degrees.
    private const double Least = 1e-3;

    private readonly double _cos = samples.Cos;
    private readonly double _sin = samples.Sin;
    private readonly double _low = samples.Low;
    private readonly double _step = samples.Step;
    private readonly (AxisStretch U, AxisStretch V)[] _axes = [.. Enumerable.Range(0, Levels).Select(samples.Axes)];

    /// <summary>The field itself if its layers are almost level or it already bends the plan.</summary>
    public static LayerField Of(LayerField field, PartColumns part)
    {
        if (field.BendsPlan) return field;
        var samples = SlopeSamples.Of(field, part, Nodes, Levels);
        return samples is not null && samples.Most - 1 > Least ? new StretchedField(field, samples) : field;
    }

    public override Vec3 ToFlat(Vec3 point) => Stretched(point.WithZ(Inner.Value(point)));

    public override Vec3 ToPart(Vec3 flat)
    {
        var place = ToPlan(flat);
        return place.WithZ(Inner.Height(place.X, place.Y, flat.Z));
    }

    /// <summary>The place in plan of a point among flat layers; its height stays the value of the field.</summary>
    public Vec3 ToPlan(Vec3 flat) => Unstretched(flat).Place;

    /// <summary>What a region among flat layers covers in plan.</summary>
    public Region ToPlan(Region region, double value)
        => Region.From(region.Contours.Select(c => new Polyline(c.Points.Select(p => ToPlan(p.WithZ(value)).WithZ(0)), closed: true)).ToArray(),
            FillRule.NonZero);

    internal override bool BendsPlan => true;

    internal override TriMesh? FlatMesh(TriMesh mesh)
    {
        var flat = Inner.FlatMesh(mesh);
        return flat is null ? null : TriMesh.Own(Array.ConvertAll(flat.RawVertices, Stretched), flat.RawTriangles);
    }

    internal override LiftedPoint Lift(Vec3 flat, double thickness)
    {
        var (place, growth) = Unstretched(flat);
        var lifted = Inner.Lift(place, thickness);
        return lifted with { Area = lifted.Area / growth };
    }

    private Vec3 Stretched(Vec3 place)
    {
        var (u, v) = Turned(place);
        var (i, t) = LevelAt(place.Z);
        return Back(At(_axes[i].U, _axes[i + 1].U, t, u), At(_axes[i].V, _axes[i + 1].V, t, v), place.Z);
    }

    // The place in plan, and the growth of areas there.
    private (Vec3 Place, double Growth) Unstretched(Vec3 flat)
    {
        var (u, v) = Turned(flat);
        var (i, t) = LevelAt(flat.Z);
        var (fromU, stretchU) = AxisStretch.Inverse(_axes[i].U, _axes[i + 1].U, t, u);
        var (fromV, stretchV) = AxisStretch.Inverse(_axes[i].V, _axes[i + 1].V, t, v);
        return (Back(fromU, fromV, flat.Z), stretchU * stretchV);
    }

    private (double U, double V) Turned(Vec3 p) => (p.X * _cos + p.Y * _sin, p.Y * _cos - p.X * _sin);

    private Vec3 Back(double u, double v, double z) => new(u * _cos - v * _sin, u * _sin + v * _cos, z);

    private (int Index, double Share) LevelAt(double value)
    {
        var t = Math.Min(Math.Max((value - _low) / _step, 0), Levels - 1);
        var i = (int)Math.Min(t, Levels - 2);
        return (i, t - i);
    }

    private static double At(AxisStretch a, AxisStretch b, double t, double u)
    {
        var low = a.At(u);
        return low + (b.At(u) - low) * t;
    }
}
