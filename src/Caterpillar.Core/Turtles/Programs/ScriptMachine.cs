namespace Caterpillar.Turtles;

/// <summary>Runs a compiled script with its own stack, so that deep recursion ends at a limit and does not overflow the stack of the thread.</summary>
internal sealed class ScriptMachine
{
    /// <summary>Maximum nesting depth of functions that formulas call.</summary>
    public const int MaxFunctionDepth = 1000;

    // Steps and moves between two looks at the clock and at the memory.
    private const int Pulse = 2048;

    // Numbers of an array that count as one step.
    private const int NumbersPerStep = 64;
    private const int MaxStates = 1_000_000;

    // A letter with a value, in two generations.
    private const int LetterBytes = 64;

    // For functions that call each other a thousand levels deep.
    private const int StackBytes = 64 << 20;

    // Where a function that a formula has called returns to.
    private const int ToFormula = -1;

    private readonly ScriptCode _code;
    private readonly string? _file;
    private readonly TurtleLimits _limits;
    private readonly IReadOnlyDictionary<string, double> _given;
    private readonly FormulaContext _context;
    private readonly ScriptFrames _frames;
    private readonly ScriptWords _words;
    private readonly ScriptPrints _prints = new();
    private readonly Stack<Open> _open = new();
    private readonly double[] _numbers = new double[TurtleCommand.MaxValues];
    private readonly CancellationToken _cancel;
    private Instruction _current;
    private long _steps;
    private long _pulse;
    private long _arrayNumbers;
    private bool _stopped;
    private int _functions;
    private double _result;

    public ScriptMachine(
        ScriptCode code, Turtle turtle, TurtleLimits limits, IReadOnlyDictionary<string, double> given, int seed, CancellationToken cancel,
        string? file = null)
    {
        _file = file;
        _code = code;
        _current = code.Instructions[0];
        Turtle = turtle;
        _limits = limits;
        _given = given;
        _cancel = cancel;
        _context = new FormulaContext(new double[Math.Max(64, code.GlobalCount)], new SeededRandom(seed)) { Host = this,
            Arrays = new double[]?[code.ArrayCount] };
        for (var i = 0; i < code.GlobalCount; i++) _context.Values[i] = double.NaN;
        _frames = new ScriptFrames(_context, code.GlobalCount, limits.MaxDepth);
        _words = new ScriptWords(code, _context);
        Look();
    }

    public Turtle Turtle { get; }

    /// <summary>Notes and warnings of the run.</summary>
    public DiagnosticList Notes { get; } = new();

    /// <summary>The printed lines of the program.</summary>
    public IEnumerable<Diagnostic> Prints => _prints.All();

    /// <summary>Estimated memory of the program, bytes.</summary>
    private long Bytes => Turtle.Bytes + 8 * (_arrayNumbers + _context.Values.Length);

    /// <exception cref="FormulaException">The program failed.</exception>
    public void Run()
    {
        if (_code.CallsFunctions) OwnThread.Run(RunHere, StackBytes);
        else RunHere();
    }

    /// <summary>The value of a function in a formula.</summary>
    /// <exception cref="FormulaException">It failed, or returned no value.</exception>
    public double Call(Procedure procedure, Evaluator[] arguments, Token at)
    {
        if (_functions >= MaxFunctionDepth) throw TooDeep(at);
        try
        {
            RuntimeHelpers.EnsureSufficientExecutionStack();
        }
        catch (InsufficientExecutionStackException)
        {
            throw TooDeep(at);
        }
        // Formulas still see the caller's variables; the new frame comes after them.
        var given = new double[arguments.Length];
        for (var i = 0; i < given.Length; i++)
        {
            given[i] = arguments[i](_context);
            if (double.IsNaN(given[i] - given[i])) throw new FormulaException("turtle.not_finite", $"A value for '{at.Text}' is not finite.", at);
        }
        var current = _current;
        _frames.Enter(procedure, given, ToFormula, _words.Count, at);
        _functions++;
        Loop(procedure.Start);
        _functions--;
        _current = current;
        if (_stopped) throw new StopException();
        return double.IsNaN(_result) ? throw new FormulaException("turtle.no_result", $"'{at.Text}' ended without returning a value.", at) : _result;
    }

    private void RunHere()
    {
        try
        {
            try
            {
                Loop(0);
            }
            catch (StopException)
            {
                // 'stop' in a function: the program ends here as well.
            }
            while (_open.Count > 0) EndShaping();
            Weigh();
        }
        catch (FormulaException e) when (e.File is null)
        {
            e.File = _current.File;
            throw;
        }
    }

    // Until the program stops, or the function of a formula returns.
    private void Loop(int pc)
    {
        var code = _code.Instructions;
        while (true)
        {
            var at = code[pc];
            _current = at;
            if (++_steps >= _pulse) Look();
            pc++;
            switch (at.Op)
            {
                case ScriptOp.Command:
                    Command(at);
                    break;
                case ScriptOp.Set:
                    _context.Values[Slot(at)] = Number(at.Arguments[0]!);
                    break;
                case ScriptOp.Parameter:
                    _context.Values[at.Slot] = _given.TryGetValue(at.Name, out var given) ? given : Number(at.Arguments[0]!);
                    break;
                case ScriptOp.SetElement:
                    SetElement(at);
                    break;
                case ScriptOp.NewArray:
                    NewArray(at);
                    break;
                case ScriptOp.Seed:
                    _context.Random = new SeededRandom((int)(Integer(at.Arguments[0]!, -1e9, 1e9)));
                    break;
                case ScriptOp.Jump:
                    pc = at.Target;
                    break;
                case ScriptOp.JumpIfFalse:
                    if (Number(at.Arguments[0]!) == 0) pc = at.Target;
                    break;
                case ScriptOp.RepeatStart:
                    var count = Math.Floor(Number(at.Arguments[0]!));
                    if (!(count > 0)) pc = at.Target;
                    else StartLoop(Slot(at), count);
                    break;
                case ScriptOp.ForStart:
                    if (!StartFor(at)) pc = at.Target;
                    break;
                case ScriptOp.RepeatNext or ScriptOp.ForNext:
                    if (++_context.Values[Slot(at)] < _context.Values[Slot(at) + 1]) pc = at.Target;
                    break;
                case ScriptOp.Call:
                    Call(at, pc);
                    pc = at.Procedure!.Start;
                    break;
                case ScriptOp.Return:
                    pc = Return(at);
                    if (pc == ToFormula) return;
                    break;
                case ScriptOp.Grow:
                    _words.Begin(Grow(at));
                    break;
                case ScriptOp.NextLetter:
                    pc = NextLetter(at, pc);
                    break;
                case ScriptOp.Print:
                    _prints.Add(TextOf(at.Text!), at.Place);
                    break;
                case ScriptOp.BeginShaping:
                    BeginShaping(at);
                    break;
                case ScriptOp.EndShaping:
                    EndShaping();
                    break;
                default:
                    _stopped = true;
                    return;
            }
        }
    }

    // Every so many steps, and after large ones: the limits and the user.
    private void Look()
    {
        _cancel.ThrowIfCancellationRequested();
        if (_steps > _limits.MaxSteps)
            throw Error(_current, "turtle.too_many_steps", $"The program was stopped after {Text(_limits.MaxSteps)} steps. Is there an endless loop?");
        Weigh();
        _pulse = Math.Min(_steps + Pulse, Math.Min(_limits.MaxSteps, long.MaxValue - 1) + 1);
    }

    private void Weigh()
    {
        if (Turtle.StackDepth > MaxStates)
        {
            throw Error(_current, "turtle.too_many_states",
                $"The program was stopped at {Text(MaxStates)} pushed states. Is there a push without a pop?");
        }
        if (_limits.Memory.Refuse(Bytes, "The moves and data of the program") is { } refusal) throw Error(_current, refusal.Code, refusal.Message);
    }

    private int Slot(Instruction at) => at.Local ? _context.Base + at.Slot : at.Slot;

    private void Command(Instruction at)
    {
        var arguments = at.Arguments;
        for (var i = 0; i < arguments.Length; i++) _numbers[i] = arguments[i] is { } argument ? Number(argument) : double.NaN;
        var moves = Turtle.MoveCount;
        if (moves >= _limits.MaxMoves) throw TooManyMoves(at);
        (Turtle.Recorder.File, Turtle.Recorder.Line) = (_file, at.At.Line);
        try
        {
            if (TraceShape.Of(at.Action, arguments.Length, _numbers) is { } shape) Draw(at, shape);
            else TurtleCommand.Apply(Turtle, at.Action, arguments.Length, _numbers, at.Text is null ? "" : TextOf(at.Text));
        }
        catch (Exception e) when (e is ArgumentException or InvalidOperationException)
        {
            throw Error(at, "turtle.value", $"'{at.Name}': {Messages.Clean(e)}");
        }
        moves = Turtle.MoveCount - moves;
        if (moves > 1) _pulse -= moves;
    }

    // A shape made of strings is counted before it is made.
    private void Draw(Instruction at, TraceShape shape)
    {
        if (!(Turtle.MoveCount + shape.Strings <= _limits.MaxMoves)) throw TooManyMoves(at);
        if (_limits.Memory.Refuse(Bytes + shape.Strings * TraceShape.StringBytes, $"{NumberFormatter.Format(shape.Strings, 0)} strings") is { } refusal)
            throw Error(at, refusal.Code, refusal.Message);
        Turtle.Draw(shape.Make(Turtle.Bead, _cancel));
    }

    private void Call(Instruction at, int back)
    {
        var given = Array.ConvertAll(at.Arguments, a => Number(a!));
        _frames.Enter(at.Procedure!, given, back, _words.Count, at.At);
    }

    private int Return(Instruction at)
    {
        _result = at.Arguments.Length > 0 ? Number(at.Arguments[0]!) : double.NaN;
        var (back, words) = _frames.Leave();
        _words.CutTo(words);
        return back;
    }

    private LSystemWord Grow(Instruction at)
    {
        var generations = (int)Integer(at.Arguments[0]!, 0, 1000);
        var seed = (int)_context.Random.NextInteger(0, int.MaxValue);
        var variables = new double[at.Variables.Count];
        for (var i = 0; i < variables.Length; i++)
        {
            var (name, slot, local) = at.Variables[i];
            variables[i] = _context.Values[local ? _context.Base + slot : slot];
            if (double.IsNaN(variables[i]) && at.System!.Variables.Uses(name))
                throw Error(at, "turtle.no_value", $"The variable '{name}' has no value yet.");
        }
        var result = at.System!.Grow(variables, generations, seed, MaxLetters(), null, _cancel);
        if (result.Value is null) throw Error(at, result.Diagnostics[0].Code, result.Diagnostics[0].Message);
        foreach (var note in result.Diagnostics) Notes.Add(note with { Source = at.Place });
        return result.Value;
    }

    // One letter of the word on top; a procedure of its name returns here.
    private int NextLetter(Instruction at, int pc)
    {
        if (!_words.Next(out var word, out var index)) return pc;
        if (_code.Letters.TryGetValue(word[index], out var procedure))
        {
            if (word.ValueCount(index) != procedure.Parameters.Count)
                throw Error(at, "lsystem.value",
                    $"The letter '{word[index]}' has {Text(word.ValueCount(index))} values, but its procedure takes {Text(procedure.Parameters.Count)}.");
            var given = new double[procedure.Parameters.Count];
            for (var v = 0; v < given.Length; v++) given[v] = word.Value(index, v);
            _frames.Enter(procedure, given, pc - 1, _words.Count, at.At);
            return procedure.Start;
        }
        if (Turtle.MoveCount >= _limits.MaxMoves) throw TooManyMoves(at);
        try
        {
            _words.Draw(Turtle, word, index);
        }
        catch (Exception e) when (e is ArgumentException or InvalidOperationException)
        {
            throw Error(at, e is InvalidOperationException ? "lsystem.bracket"
                : "lsystem.value", $"Letter {Text(index + 1)} ('{word[index]}') of the word: {Messages.Clean(e)}");
        }
        return pc - 1;
    }

    private int MaxLetters() => (int)Math.Max(1, Math.Min(_limits.MaxSymbols, (_limits.Memory.Bytes - Bytes) / LetterBytes));

    private void BeginShaping(Instruction at) => _open.Push(new Open(at.Shaping!, Turtle.Pose, Turtle.Recorder.Begin(), _context.Base));

    private void EndShaping()
    {
        var block = _open.Pop();
        var (current, at) = (_context.Base, block.Rules.At);
        // A program that stops within a procedure ends the blocks around its calls as well.
        _context.Base = block.Base;
        var steps = Turtle.Recorder.From(block.First);
        if (_limits.Memory.Refuse(Bytes + 2 * Turtle.Bytes, "The shaped paths") is { } refusal)
            throw new FormulaException(refusal.Code, refusal.Message, at);
        var shaped = new Shaper(block.Rules, _context, block.Frame, Turtle).Apply(steps, _cancel);
        if (shaped.Value is null) throw new FormulaException(shaped.Diagnostics[0].Code, shaped.Diagnostics[0].Message, at);
        foreach (var note in shaped.Diagnostics) Notes.Add(note with { Source = new SourceLocation(_current.File, at.Line, at.Column) });
        Turtle.Recorder.Replace(block.First, shaped.Value);
        _context.Base = current;
        _pulse = Math.Min(_pulse, _steps);
    }

    private FormulaException TooManyMoves(Instruction at)
        => Error(at, "turtle.too_many_moves", $"The program was stopped after {Text(_limits.MaxMoves)} moves.");

    private void NewArray(Instruction at)
    {
        var size = (int)Integer(at.Arguments[0]!, 0, _limits.MaxSymbols);
        _arrayNumbers += size - (_context.Arrays[at.Slot]?.Length ?? 0);
        // Before it is made; an array counts for its size, so that a loop of them ends.
        _steps += size / NumbersPerStep;
        Look();
        _context.Arrays[at.Slot] = new double[size];
    }

    private double Number(Argument argument)
    {
        var value = argument.Constant;
        if (!double.IsNaN(value)) return value;
        value = argument.Evaluate(_context);
        if (!double.IsNaN(value - value)) return value;
        var message = double.IsNaN(value)
            ? "The value is not a number. Causes: 0 / 0, a root or logarithm of a negative number, or randint(from, to) without an integer in between."
            : "The value is infinite: division by zero, or a number too large.";
        throw new FormulaException("turtle.not_finite", message, argument.At);
    }

    private double Integer(Argument argument, double low, double high)
    {
        var value = Number(argument);
        if (value >= low && value <= high && value == Math.Floor(value)) return value;
        throw new FormulaException("turtle.value",
            $"Found {NumberFormatter.Format(value, 6)}, expected an integer from {NumberFormatter.Format(low, 0)} to {NumberFormatter.Format(high, 0)}.",
            argument.At);
    }

    private void SetElement(Instruction at)
    {
        var array = _context.Arrays[at.Slot] ?? throw Error(at, "turtle.index", $"The array '{at.Name}' has not been created yet.");
        var index = ScriptScope.Index(Number(at.Arguments[0]!), array.Length, at.Name, at.At);
        array[index] = Number(at.Arguments[1]!);
    }

    private void StartLoop(int slot, double count)
    {
        _context.Values[slot] = 0;
        _context.Values[slot + 1] = count;
    }

    private bool StartFor(Instruction at)
    {
        var from = Number(at.Arguments[0]!);
        var to = Number(at.Arguments[1]!);
        var step = at.Arguments[2] is { } given ? Number(given) : 1;
        if (step == 0) throw new FormulaException("turtle.value", "The step of a loop must not be 0.", at.Arguments[2]!.At);
        // Slightly more, so that 0 to 1 step 0.1 has its 11 iterations.
        var count = Math.Floor((to - from) / step + 1e-9) + 1;
        if (!(count > 0)) return false;
        var slot = Slot(at);
        StartLoop(slot, count);
        _context.Values[slot + 2] = from;
        _context.Values[slot + 3] = step;
        return true;
    }

    private string TextOf(TextTemplate template)
    {
        if (template.Values.Count == 0) return template.Texts[0];
        var text = new StringBuilder();
        for (var i = 0; i < template.Values.Count; i++) text.Append(template.Texts[i]).Append(NumberFormatter.Format(Number(template.Values[i]), 6));
        return text.Append(template.Texts[template.Values.Count]).ToString();
    }

    private static string Text(long number) => NumberFormatter.Format(number);

    private static FormulaException TooDeep(Token at) => new("turtle.recursion",
        $"Function calls are nested {Text(MaxFunctionDepth)} levels deep. Is there an endless recursion?", at);

    private static FormulaException Error(Instruction at, string code, string message) => new(code, message, at.At);

    private readonly record struct Open(ShapingRules Rules, Frame Frame, int First, int Base);

    // Ends the program from within a function.
    private sealed class StopException : Exception
    {
    }
}
