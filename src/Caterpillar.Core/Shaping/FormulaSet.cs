namespace Caterpillar.Shaping;

/// <summary>Compiles the formulas of a deformation or a field over the same variables, and evaluates them from any thread.</summary>
internal sealed class FormulaSet(string[] variables, SourceLocation? source)
{
    private readonly SourceLocation _source = source ?? new SourceLocation();
    private readonly Func<FormulaContext> _context = FormulaContext.OfThread(variables.Length);

    /// <summary>One for each wrong formula.</summary>
    public List<Diagnostic> Problems { get; } = [];

    /// <summary>A formula, or none with an error that names it and gives the column.</summary>
    /// <param name="text">The formula.</param>
    /// <param name="purpose">Purpose of the formula, which is the key of its diagnostics.</param>
    public Formula? Compile(string text, string purpose)
    {
        var place = _source with { Key = _source.Key is null ? purpose : _source.Key + "." + purpose };
        if (text.Trim().Length == 0)
        {
            Problems.Add(new Diagnostic(Severity.Error, "formula.empty", $"The formula of {purpose} is empty.", place));
            return null;
        }
        var compiled = Formula.Compile(text, variables, place);
        foreach (var problem in compiled.Diagnostics) Problems.Add(problem with { Message = $"{problem.Message} (formula of {purpose}: \"{text.Trim()}\")" });
        if (compiled.Value is not { UsesRandom: true } formula) return compiled.Value;
        // Its value would depend on the order of evaluation.
        Problems.Add(new Diagnostic(Severity.Error, "formula.random",
            $"The formula of {purpose} uses random numbers. Use random(seed), which has one value for each seed.",
            place));
        return null;
    }

    /// <summary>The context of this thread, with values to set.</summary>
    public FormulaContext Context => _context();
}
