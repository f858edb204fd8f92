namespace Caterpillar.Curved;

/// <summary>A field given by a formula in x, y and z that rises with z.</summary>
internal sealed class FormulaField(Func<Vec3, double> value, double detail) : LayerField
{
    public override double Detail => detail;

    public override double Value(Vec3 point) => value(point);

    internal override LayerField FitTo(PartColumns part, PrintSettings settings, DiagnosticList problems)
    {
        foreach (var column in part.Columns)
        {
            const int Steps = 16;
            var from = new Vec3(column.X, column.Y, column.Low);
            var last = Value(from);
            for (var i = 1; i <= Steps; i++)
            {
                // Columns of no height are tested, too.
                var at = from.WithZ(column.Low + Math.Max(column.High - column.Low, 0.01) * i / Steps);
                var next = Value(at);
                if (!(next > last))
                {
                    var what = double.IsNaN(next - last) ? "has no value" : "does not rise with z";
                    problems.Add(Severity.Error, "curved.overhanging_layers", $"The field {what} at {at}. A nozzle from above cannot print such layers.");
                    return this;
                }
                last = next;
            }
        }
        return Anchored(this, part, settings);
    }
}
