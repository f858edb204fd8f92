namespace Caterpillar.Curved;

/// <summary>A formula over a place: x, y, z in mm, and r (mm) and theta (degrees, −180 to 180) about the Z axis. For any thread.</summary>
internal sealed class FieldFormula(Formula formula)
{
    /// <summary>Formulas are expected to have no features smaller than this, mm.</summary>
    public const double Detail = 2;

    private static readonly string[] Variables = ["x", "y", "z", "r", "theta"];
    private readonly Func<FormulaContext> _context = FormulaContext.OfThread(Variables.Length);
    private readonly bool _usesAngle = formula.Text.IndexOf("theta", StringComparison.OrdinalIgnoreCase) >= 0;

    public bool IsConstant => formula.IsConstant;

    public static Result<FieldFormula> Compile(string text, SourceLocation? source)
    {
        var compiled = Formula.Compile(text, Variables, source);
        if (compiled.Value is not { } own) return new Result<FieldFormula>(null, compiled.Diagnostics);
        if (!own.UsesRandom) return new Result<FieldFormula>(new FieldFormula(own), compiled.Diagnostics);
        return new Result<FieldFormula>(null, [new Diagnostic(Severity.Error, "formula.random",
            "The formula of the field uses random numbers. Use random(seed), which has one value for each seed.", source)]);
    }

    public double At(double x, double y, double z)
    {
        var context = _context();
        var values = context.Values;
        values[0] = x;
        values[1] = y;
        values[2] = z;
        values[3] = Math.Sqrt(x * x + y * y);
        if (_usesAngle) values[4] = Angle.Atan2(y, x);
        return formula.Evaluate(context);
    }
}
