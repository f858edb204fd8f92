namespace Caterpillar.Expressions;

/// <summary>Lends contexts of formulas with the same variables to any thread, and keeps one for the next caller.</summary>
internal sealed class SpareContext(int variables)
{
    private FormulaContext? _spare;

    /// <summary>A context to fill with values. No other thread uses it until it is returned.</summary>
    public FormulaContext Rent() => Interlocked.Exchange(ref _spare, null) ?? new FormulaContext(new double[variables]);

    public void Return(FormulaContext context) => Volatile.Write(ref _spare, context);
}
