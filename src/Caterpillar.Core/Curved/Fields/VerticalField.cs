namespace Caterpillar.Curved;

/// <summary>Range in which layers change from level to parallel with the plan, as values of the field, mm.</summary>
/// <param name="From">Layers below this value are level.</param>
/// <param name="To">Layers above this value are parallel to the plan. Infinity spreads the change over all layers up to the plan.</param>
public readonly record struct LayerBlend(double From, double To);

/// <summary>
/// Layers that are copies of a plan surface, moved up and down; below, they may blend into level layers: z = value + (plan − level) · share(value), where the
/// share rises from 0 to 1. The level is the value of the plan's own layer; in the zone of the blend layers are thinner where the plan is low.
/// </summary>
/// <param name="plan">The surface.</param>
/// <param name="blend">Where layers change from level; null where all are parallel to the surface.</param>
/// <param name="level">The value of the plan's own layer, mm.</param>
internal sealed class VerticalField(PlanSurface plan, LayerBlend? blend, double level = 0) : LayerField
{
    public override double Detail => plan.Detail;

    public override bool StartsLevel => blend is not null || plan.IsLevel;

    internal override IReadOnlyList<double> Creases => blend is { } zone ? [zone.From, zone.To] : [];

    internal override double Span(Vec3 step) => step.LengthXY;

    internal override void Check(DiagnosticList problems) => plan.Check(problems);

    public override bool Covers(double x, double y) => plan.Covers(x, y);

    public override double Value(Vec3 point)
    {
        var shift = plan.Height(point.X, point.Y) - level;
        if (blend is not { } zone) return point.Z - shift;
        if (point.Z <= zone.From) return point.Z;
        if (point.Z >= zone.To + shift) return point.Z - shift;
        var height = zone.To - zone.From;
        return zone.From + (point.Z - zone.From) * height / (height + shift);
    }

    internal override double Spread(Vec3 point)
    {
        if (blend is not { } zone || point.Z <= zone.From) return 1;
        var shift = plan.Height(point.X, point.Y) - level;
        return point.Z >= zone.To + shift ? 1 : 1 + shift / (zone.To - zone.From);
    }

    public override double Height(double x, double y, double value) => HeightOf(value, plan.Height(x, y) - level);

    public override Vec3 Normal(Vec3 point)
    {
        var share = 1.0;
        if (blend is { } zone)
        {
            var value = Value(point);
            if (value <= zone.From) return Vec3.UnitZ;
            share = Math.Min(1, (value - zone.From) / (zone.To - zone.From));
        }
        var (byX, byY) = plan.Slope(point.X, point.Y);
        return new Vec3(-byX * share, -byY * share, 1).Unit();
    }

    internal override (double First, double Second) Heights(double x, double y, double first, double second)
    {
        var shift = plan.Height(x, y) - level;
        return (HeightOf(first, shift), HeightOf(second, shift));
    }

    internal override LayerField FitTo(PartColumns part, PrintSettings settings, DiagnosticList problems)
    {
        PlanSteps.Check(plan, part, problems);
        if (problems.HasErrors) return this;
        if (blend is not { } zone) return Anchored(this, part, settings);
        var places = part.Columns.Select(c => new Vec3(c.X, c.Y, plan.Height(c.X, c.Y))).DefaultIfEmpty().ToArray();
        var lowest = places.Aggregate((low, next) => next.Z < low.Z ? next : low);
        var high = places.Max(p => p.Z);
        // The plan is the border of two layers; nowhere are layers thicker than the layer height.
        var top = settings.FirstLayerHeight
            + Math.Max(0, Math.Ceiling((high - settings.FirstLayerHeight) / settings.LayerHeight - 1e-6)) * settings.LayerHeight;
        var from = Math.Max(zone.From, settings.FirstLayerHeight);
        var to = Math.Min(zone.To, top);
        if (!(to - from > top - lowest.Z))
        {
            problems.Add(Severity.Error, "curved.blend_too_short",
                $"The blend from level layers to the plan between {Text(from)} and {Text(to)} mm is too short: layers would cross. The plan is "
                + $"{Text(top - lowest.Z)} mm lower at {lowest} than at its highest point. Make the blend longer than that."
                + PlanSurface.Otherwise);
            return this;
        }
        return new VerticalField(plan, new LayerBlend(from, to), top);
    }

    private double HeightOf(double value, double shift)
    {
        if (blend is not { } zone) return value + shift;
        if (value <= zone.From) return value;
        return value >= zone.To ? value + shift : value + shift * (value - zone.From) / (zone.To - zone.From);
    }

    private static string Text(double value) => NumberFormatter.Format(value, 2);
}
