namespace Caterpillar.Turtles;

/// <summary>A program for a turtle: a script, a list of commands, or an L-system word, ready to run. Immutable.</summary>
public sealed class TurtleProgram
{
    private readonly Func<Turtle, TurtleLimits, CancellationToken, IReadOnlyList<Diagnostic>> _run;

    private TurtleProgram(
        string description, Func<Turtle, TurtleLimits, CancellationToken, IReadOnlyList<Diagnostic>> run, IReadOnlyList<string>? profiles = null)
        => (Description, _run, Profiles) = (description, run, profiles ?? []);

    /// <summary>Names of the printer, material and settings profiles of the script (<c>use</c>). All or the later ones may be missing.</summary>
    public IReadOnlyList<string> Profiles { get; }

    /// <summary>Description in one line.</summary>
    public string Description { get; }

    /// <summary>A program from a script and the values of its parameters.</summary>
    public static TurtleProgram FromScript(TurtleScript script, IReadOnlyDictionary<string, double>? variables = null, int seed = 0)
    {
        if (script is null) throw new ArgumentNullException(nameof(script));
        var lines = script.Text.Count(c => c == '\n') + 1;
        return new TurtleProgram($"Script of {NumberFormatter.Format(lines)} lines",
            (t, limits, cancel) => script.Run(t, variables, seed, limits, null, cancel), script.Profiles);
    }

    /// <summary>A program from a list of commands.</summary>
    public static TurtleProgram FromCommands(IEnumerable<TurtleCommand> commands)
    {
        var list = (commands ?? throw new ArgumentNullException(nameof(commands))).ToArray();
        return new TurtleProgram($"{NumberFormatter.Format(list.Length)} commands", (t, limits, cancel) => Run(list, t, limits, cancel));
    }

    /// <summary>A program from an L-system word, its step in mm and its angle in degrees: see <see cref="LSystemWord.Draw"/>.</summary>
    public static TurtleProgram FromWord(LSystemWord word, double step, double angle)
    {
        if (word is null) throw new ArgumentNullException(nameof(word));
        return new TurtleProgram($"L-system of {NumberFormatter.Format(word.Count)} letters", (t, _, cancel) => word.Draw(t, step, angle, cancel));
    }

    /// <summary>A program that runs other programs in order with the same turtle.</summary>
    public static TurtleProgram Sequence(IEnumerable<TurtleProgram> programs)
    {
        var list = (programs ?? throw new ArgumentNullException(nameof(programs))).ToArray();
        return new TurtleProgram(string.Join(", ", list.Select(p => p.Description)), (t, limits, cancel) =>
        {
            var diagnostics = new DiagnosticList();
            foreach (var program in list)
            {
                diagnostics.AddRange(program._run(t, limits, cancel));
                if (diagnostics.HasErrors) break;
            }
            return diagnostics.ToList();
        }, list.Select(p => p.Profiles).FirstOrDefault(p => p.Count > 0));
    }

    /// <summary>Runs the program with a new turtle.</summary>
    /// <returns>The turtle at the end. Null if an error stopped the program.</returns>
    public Result<Turtle> Run(TurtleOptions? options = null, TurtleLimits? limits = null, IProgress<double>? progress = null,
        CancellationToken cancel = default)
    {
        var turtle = new Turtle(options);
        var diagnostics = _run(turtle, limits ?? new TurtleLimits(), cancel);
        progress?.Report(1);
        return new Result<Turtle>(diagnostics.Any(d => d.Severity == Severity.Error) ? null : turtle, diagnostics);
    }

    public override string ToString() => Description;

    private static IReadOnlyList<Diagnostic> Run(TurtleCommand[] commands, Turtle turtle, TurtleLimits limits, CancellationToken cancel)
    {
        // Lists that are being executed, the innermost last; with a separate stack no nesting is too deep.
        var open = new Stack<Cursor>();
        open.Push(new Cursor(commands, 1));
        var steps = 0L;
        while (open.Count > 0)
        {
            var cursor = open.Peek();
            if (cursor.At == cursor.Commands.Count)
            {
                cursor.At = 0;
                if (--cursor.Turns <= 0) open.Pop();
                if (++steps > limits.MaxSteps) return [Stopped(limits.MaxSteps, "steps", "turtle.too_many_steps")];
                continue;
            }
            var command = cursor.Commands[cursor.At++];
            if (++steps > limits.MaxSteps) return [Stopped(limits.MaxSteps, "steps", "turtle.too_many_steps")];
            if ((steps & 0x3FFF) == 0) cancel.ThrowIfCancellationRequested();
            if (command.Action == TurtleAction.Repeat)
            {
                if (command.Body.Count > 0 && command.Values[0] >= 1) open.Push(new Cursor(command.Body, (long)command.Values[0]));
                continue;
            }
            if (turtle.MoveCount >= limits.MaxMoves) return [Stopped(limits.MaxMoves, "moves", "turtle.too_many_moves")];
            try
            {
                command.Apply(turtle);
            }
            catch (Exception e) when (e is ArgumentException or InvalidOperationException)
            {
                return [new Diagnostic(Severity.Error, "turtle.value", $"'{command}': {Messages.Clean(e)}")];
            }
        }
        return [];
    }

    private static Diagnostic Stopped(long limit, string what, string code)
        => new(Severity.Error, code, $"The program was stopped after {NumberFormatter.Format(limit)} {what}.");

    private sealed class Cursor(IReadOnlyList<TurtleCommand> commands, long turns)
    {
        public IReadOnlyList<TurtleCommand> Commands { get; } = commands;

        public long Turns { get; set; } = turns;

        public int At { get; set; }
    }
}
