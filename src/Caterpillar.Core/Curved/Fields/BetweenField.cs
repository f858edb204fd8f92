namespace Caterpillar.Curved;

/// <summary>
/// Layers that divide the space between surfaces, each above the one before: between two of them there is everywhere the same number of layers, which are thin
/// where the surfaces come together. Beyond the lowest and the highest surface the layers go on with the thickness they have there.
/// </summary>
internal sealed class BetweenField(PlanSurface[] surfaces) : LayerField
{
    // Value of the field on each surface.
    private readonly double[] _values = surfaces.Select((_, i) => (double)i).ToArray();

    private BetweenField(PlanSurface[] surfaces, double[] values) : this(surfaces) => _values = values;

    // The quotient of two planes is curved, gently.
    public override double Detail { get; } = surfaces.Min(s => s.Detail) is < double.PositiveInfinity and var least ? least : 10;

    public override bool StartsLevel => surfaces[0].IsLevel;

    internal override IReadOnlyList<double> Creases => _values;

    internal override double Span(Vec3 step) => step.LengthXY;

    internal override void Check(DiagnosticList problems) => Array.ForEach(surfaces, s => s.Check(problems));

    public override bool Covers(double x, double y) => Array.TrueForAll(surfaces, s => s.Covers(x, y));

    public override double Value(Vec3 point)
    {
        var (i, low, high) = Around(point);
        return _values[i - 1] + (_values[i] - _values[i - 1]) * (point.Z - low) / (high - low);
    }

    public override double Height(double x, double y, double value)
    {
        var i = 1;
        while (i + 1 < surfaces.Length && value > _values[i]) i++;
        double low = surfaces[i - 1].Height(x, y), high = surfaces[i].Height(x, y);
        return low + (high - low) * (value - _values[i - 1]) / (_values[i] - _values[i - 1]);
    }

    internal override double Spread(Vec3 point)
    {
        var (i, low, high) = Around(point);
        return (high - low) / (_values[i] - _values[i - 1]);
    }

    public override Vec3 Normal(Vec3 point)
    {
        var (i, low, high) = Around(point);
        var share = (point.Z - low) / (high - low);
        var (lowX, lowY) = surfaces[i - 1].Slope(point.X, point.Y);
        var (highX, highY) = surfaces[i].Slope(point.X, point.Y);
        return new Vec3(-lowX - (highX - lowX) * share, -lowY - (highY - lowY) * share, 1).Unit();
    }

    internal override LayerField FitTo(PartColumns part, PrintSettings settings, DiagnosticList problems)
    {
        foreach (var surface in surfaces) PlanSteps.Check(surface, part, problems);
        if (problems.HasErrors) return this;
        var values = new double[surfaces.Length];
        for (var i = 1; i < values.Length; i++)
        {
            var most = 0.0;
            foreach (var column in part.Columns)
            {
                double low = surfaces[i - 1].Height(column.X, column.Y), high = surfaces[i].Height(column.X, column.Y);
                if (!(high > low))
                {
                    problems.Add(Severity.Error, "curved.surfaces_cross",
                        $"The bounding surfaces meet or cross at {new Vec3(column.X, column.Y, low)} and leave no room for layers."
                        + PlanSurface.Otherwise);
                    return this;
                }
                most = Math.Max(most, high - low);
            }
            var first = i == 1 ? settings.FirstLayerHeight : 0;
            values[i] = values[i - 1] + first + Math.Max(i == 1 ? 0 : 1, Math.Ceiling((most - first) / settings.LayerHeight - 1e-6)) * settings.LayerHeight;
        }
        return Anchored(new BetweenField(surfaces, values), part, settings);
    }

    // The heights of the surfaces below and above a point, and the number of the upper one.
    private (int Upper, double Low, double High) Around(Vec3 point)
    {
        var low = surfaces[0].Height(point.X, point.Y);
        for (var i = 1; ; i++)
        {
            var high = surfaces[i].Height(point.X, point.Y);
            if (point.Z <= high || i + 1 == surfaces.Length) return (i, low, high);
            low = high;
        }
    }
}
