using System;
using System.Collections.Generic;
using Caterpillar.Basics;
using Caterpillar.Geometry;
using Caterpillar.Machines;

namespace Caterpillar.Curved;

/// <summary>Where layers change from level to parallel with the plan, as values of the field, mm.</summary>
/// <param name="From">Below this layers are level.</param>
/// <param name="To">Above this they are parallel to the plan; infinite to spread the change over all layers up to the plan.</param>
public readonly record struct LayerBlend(double From, double To);

/// <summary>
/// Layers that are copies of a plan surface, moved up and down; below, they may blend into level layers: z = value + (plan − level) · share(value), where the
/// share rises from 0 to 1. The level is the value of the plan's own layer; in the zone of the blend layers are thinner where the plan is low.
/// </summary>
internal sealed class VerticalField : LayerField
{
    private readonly PlanSurface _plan;
    private readonly LayerBlend? _blend;
    private readonly double _level;

    private VerticalField(PlanSurface plan, LayerBlend? blend, double level)
    {
        _plan = plan;
        _blend = blend;
        _level = level;
    }

    public static VerticalField Of(PlanSurface plan, LayerBlend? blend) => new(plan, blend, 0);

    public override double Detail => _plan.Detail;

    public override bool StartsLevel => _blend is not null || _plan.IsLevel;

    internal override IReadOnlyList<double> Creases => _blend is { } blend ? [blend.From, blend.To] : [];

    internal override double Span(Vec3 step) => step.LengthXY;

    internal override void Check(DiagnosticList problems) => _plan.Check(problems);

    public override bool Covers(double x, double y) => _plan.Covers(x, y);

    public override double Value(Vec3 point)
    {
        var shift = _plan.Height(point.X, point.Y) - _level;
        if (_blend is not { } blend) return point.Z - shift;
        if (point.Z <= blend.From) return point.Z;
        if (point.Z >= blend.To + shift) return point.Z - shift;
        var zone = blend.To - blend.From;
        return blend.From + (point.Z - blend.From) * zone / (zone + shift);
    }

    internal override double Spread(Vec3 point)
    {
        if (_blend is not { } blend || point.Z <= blend.From) return 1;
        var shift = _plan.Height(point.X, point.Y) - _level;
        return point.Z >= blend.To + shift ? 1 : 1 + shift / (blend.To - blend.From);
    }

    public override double Height(double x, double y, double value) => HeightOf(value, _plan.Height(x, y) - _level);

    public override Vec3 Normal(Vec3 point)
    {
        var share = 1.0;
        if (_blend is { } blend)
        {
            var value = Value(point);
            if (value <= blend.From) return Vec3.UnitZ;
            share = Math.Min(1, (value - blend.From) / (blend.To - blend.From));
        }
        var (byX, byY) = _plan.Slope(point.X, point.Y);
        return new Vec3(-byX * share, -byY * share, 1).Unit();
    }

    internal override (double First, double Second) Heights(double x, double y, double first, double second)
    {
        var shift = _plan.Height(x, y) - _level;
        return (HeightOf(first, shift), HeightOf(second, shift));
    }

    internal override LayerField FitTo(PartColumns part, PrintSettings settings, DiagnosticList problems)
    {
        if (_blend is not { } blend) return Anchored(this, part, settings);
        var (low, high) = (double.PositiveInfinity, double.NegativeInfinity);
        var lowest = Vec3.Zero;
        foreach (var column in part.Columns)
        {
            var height = _plan.Height(column.X, column.Y);
            if (height < low) (low, lowest) = (height, new Vec3(column.X, column.Y, height));
            high = Math.Max(high, height);
        }
        // The plan is the border of two layers; nowhere are layers thicker than the layer height.
        var level = settings.FirstLayerHeight
            + Math.Max(0, Math.Ceiling((high - settings.FirstLayerHeight) / settings.LayerHeight - 1e-6)) * settings.LayerHeight;
        var from = Math.Max(blend.From, settings.FirstLayerHeight);
        var to = Math.Min(blend.To, level);
        if (!(to - from > level - low))
        {
            problems.Add(Severity.Error, "curved.blend_too_short",
                $"Layers cannot change from level to the plan between {Text(from)} and {Text(to)} mm: the plan is {Text(level - low)} mm lower at {lowest} "
                    + $"than "
                + $"at its highest place, and layers would cross. The change needs more than {Text(level - low)} mm.");
            return this;
        }
        return new VerticalField(_plan, new LayerBlend(from, to), level);
    }

    private double HeightOf(double value, double shift)
    {
        if (_blend is not { } blend) return value + shift;
        if (value <= blend.From) return value;
        return value >= blend.To ? value + shift : value + shift * (value - blend.From) / (blend.To - blend.From);
    }

    private static string Text(double value) => NumberFormatter.Format(value, 2);
}
