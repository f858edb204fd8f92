namespace Caterpillar.Expressions;

/// <summary>
/// Input of the evaluation of a formula: the values of its variables by slot, and random numbers. One thread at a time may use a context. Its values
/// may change between evaluations.
/// </summary>
/// <param name="values">Values of the variables in the order of <see cref="Formula.Compile"/>; kept, not copied.</param>
/// <param name="random">Source of <c>random()</c>; null = a new one with seed 0.</param>
internal sealed class FormulaContext(double[] values, SeededRandom? random = null)
{
    /// <summary>Values by slot.</summary>
    public double[] Values { get; set; } = values ?? throw new ArgumentNullException(nameof(values));

    /// <summary>Source of <c>random()</c>, <c>random(a, b)</c> and <c>randint(a, b)</c>.</summary>
    public SeededRandom Random { get; set; } = random ?? new SeededRandom();

    // First slot of the procedure that runs; scripts only.
    public int Base { get; set; }

    // The runner of a script; scripts only.
    public object? Host { get; set; }

    public double[]?[] Arrays { get; set; } = [];

    /// <summary>A context with so many variables for each thread that asks.</summary>
    public static Func<FormulaContext> OfThread(int variables)
    {
        var contexts = new ThreadLocal<FormulaContext>(() => new FormulaContext(new double[variables]));
        return () => contexts.Value!;
    }
}
