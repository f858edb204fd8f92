namespace Caterpillar.Turtles;

/// <summary>
/// A compiled turtle program. A script has commands (<see cref="TurtleCommands"/>), formulas (<see cref="Formula"/>), variables, <c>repeat</c>, <c>for</c>,
/// <c>while</c>, <c>if</c> and <c>else</c>, arrays, procedures (<c>def</c>), L-systems and comments. Statements are on separate lines or separated by
/// <c>;</c>. docs/turtle.md is the manual. Problems are diagnostics with line and column. <see cref="TurtleLimits"/> stop endless programs. Scripts are
/// immutable and can run on several threads at once.
/// </summary>
public sealed class TurtleScript
{
    /// <summary>Code of the notes for lines that the program prints (<c>print</c>). They come first, in their order.</summary>
    public const string PrintCode = "turtle.print";

    private readonly ScriptCode _code;
    private readonly string? _file;

    private TurtleScript(string text, string? file, ScriptCode code) => (Text, _file, _code) = (text, file, code);

    /// <summary>The text of the script.</summary>
    public string Text { get; }

    /// <summary>Names of the parameters, in order (<c>param name = default</c>).</summary>
    public IReadOnlyList<string> Parameters => _code.Parameters;

    /// <summary>Names of the printer, material and settings profiles of the script (<c>use</c>). All or the later ones may be missing.</summary>
    public IReadOnlyList<string> Profiles => _code.Profiles;

    /// <summary>Compiles a script. Errors in the text are not exceptions. Only the first error is returned.</summary>
    /// <param name="text">The text of the script.</param>
    /// <param name="file">Its name, for diagnostics.</param>
    /// <param name="files">The files that the script may read (<c>include</c>, <c>image</c>). By default, none.</param>
    public static Result<TurtleScript> Compile(string text, string? file = null, ScriptFiles? files = null)
    {
        if (text is null) throw new ArgumentNullException(nameof(text));
        try
        {
            return new Result<TurtleScript>(new TurtleScript(text, file, ScriptCompiler.Compile(text, file, files ?? ScriptFiles.None)), []);
        }
        catch (FormulaException e)
        {
            return new Result<TurtleScript>(null, [Problem(e, file)]);
        }
    }

    /// <summary>Runs the script with a new turtle.</summary>
    /// <param name="options">The initial state of the turtle.</param>
    /// <param name="variables">Values of parameters. An unknown name is a warning.</param>
    /// <param name="seed">Seed of <c>random()</c> until the script sets its own.</param>
    /// <param name="limits">Limits that stop the script.</param>
    /// <param name="progress">Reports 1 at the end. The length of a run is not known before.</param>
    /// <param name="cancel">Stops with <see cref="OperationCanceledException"/>.</param>
    /// <returns>The turtle at the end. Null if an error stopped the script.</returns>
    public Result<Turtle> Run(
        TurtleOptions? options = null,
        IReadOnlyDictionary<string, double>? variables = null,
        int seed = 0,
        TurtleLimits? limits = null,
        IProgress<double>? progress = null,
        CancellationToken cancel = default)
    {
        var turtle = new Turtle(options);
        var diagnostics = Run(turtle, variables, seed, limits, progress, cancel);
        return new Result<Turtle>(diagnostics.Any(d => d.Severity == Severity.Error) ? null : turtle, diagnostics);
    }

    /// <summary>Runs the script with an existing turtle. After an error, the turtle is where the script stopped.</summary>
    /// <inheritdoc cref="Run(TurtleOptions?, IReadOnlyDictionary{string, double}?, int, TurtleLimits?, IProgress{double}?, CancellationToken)"/>
    public IReadOnlyList<Diagnostic> Run(
        Turtle turtle,
        IReadOnlyDictionary<string, double>? variables = null,
        int seed = 0,
        TurtleLimits? limits = null,
        IProgress<double>? progress = null,
        CancellationToken cancel = default)
    {
        if (turtle is null) throw new ArgumentNullException(nameof(turtle));
        var given = variables ?? new Dictionary<string, double>();
        var diagnostics = new DiagnosticList();
        var place = _file is null ? null : new SourceLocation(_file);
        foreach (var name in given.Keys.Where(n => !Parameters.Contains(n)).OrderBy(n => n, StringComparer.Ordinal))
            diagnostics.Add(Severity.Warning, "turtle.parameter", $"The program has no parameter '{name}'.{SpellingSuggestion.Hint(name, Parameters)}",
                place);
        foreach (var name in given.Keys.Where(n => double.IsNaN(given[n]) || double.IsInfinity(given[n])).OrderBy(n => n, StringComparer.Ordinal))
            diagnostics.Add(Severity.Error, "turtle.not_finite", $"The value of '{name}' is not finite.", place);
        if (diagnostics.HasErrors) return diagnostics.ToList();
        var unclosed = turtle.StackDepth;
        var machine = new ScriptMachine(_code, turtle, limits ?? new TurtleLimits(), given, seed, cancel, _file);
        try
        {
            machine.Run();
            if (turtle.StackDepth > unclosed)
                diagnostics.Add(Severity.Note, "turtle.push", $"Pushed states without a pop: {NumberFormatter.Format(turtle.StackDepth - unclosed)}.",
                    place);
        }
        catch (FormulaException e)
        {
            diagnostics.Add(Problem(e, _file));
        }
        foreach (var note in machine.Notes.ToList()) diagnostics.Add(note with { Source = note.Source! with { File = note.Source.File ?? _file } });
        progress?.Report(1);
        return [.. machine.Prints.Select(p => p.Source is { File: null } own ? p with { Source = own with { File = _file } } : p),
            .. diagnostics.ToList()];
    }

    private static Diagnostic Problem(FormulaException e, string? file)
        => new(Severity.Error, e.Code, e.Message, new SourceLocation(e.File ?? file, e.Line, e.Column));
}
