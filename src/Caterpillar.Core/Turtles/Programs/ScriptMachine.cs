using System;
using System.Collections.Generic;
using System.Text;
using System.Threading;
using Caterpillar.Basics;
using Caterpillar.Expressions;

namespace Caterpillar.Turtles;

/// <summary>Runs a compiled script with a stack of its own, so that deep recursion ends at a limit and does not overflow the thread's stack.</summary>
internal sealed partial class ScriptMachine
{
    // Steps and moves between two looks at the clock and at the memory.
    private const int Pulse = 2048;

    // Numbers of an array that count as one step.
    private const int NumbersPerStep = 64;

    private readonly ScriptCode _code;
    private readonly string? _file;
    private readonly TurtleLimits _limits;
    private readonly IReadOnlyDictionary<string, double> _given;
    private readonly FormulaContext _context;
    private readonly List<Letters> _words = [];
    private readonly double[] _numbers = new double[TurtleCommand.MaxValues];
    private readonly CancellationToken _cancel;
    private Instruction _current;
    private long _steps;
    private long _pulse;
    private long _arrayNumbers;
    private bool _stopped;

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
        _frameSize = code.GlobalCount;
        _context = new FormulaContext(new double[Math.Max(64, code.GlobalCount)], new SeededRandom(seed)) { Host = this,
            Arrays = new double[]?[code.ArrayCount] };
        for (var i = 0; i < _frameSize; i++) _context.Values[i] = double.NaN;
        Look();
    }

    public Turtle Turtle { get; }

    /// <summary>What was noticed while it ran.</summary>
    public DiagnosticList Remarks { get; } = new();

    /// <summary>An estimate of what the program holds, in bytes.</summary>
    private long Bytes => Turtle.Bytes + 8 * (_arrayNumbers + _context.Values.Length);

    /// <exception cref="FormulaException">The program failed.</exception>
    public void Run()
    {
        if (_code.CallsFunctions) OnLargeStack(RunHere);
        else RunHere();
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
                    if (NextTurn(Slot(at))) pc = at.Target;
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
                    _words.Add(new Letters(Grow(at)));
                    break;
                case ScriptOp.NextLetter:
                    pc = NextLetter(at, pc);
                    break;
                case ScriptOp.Print:
                    Print(at);
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
        {
            throw Error(_current, "turtle.endless", $"The program was stopped after {Text(_limits.MaxSteps)} steps. Does a loop never end?");
        }
        Weigh();
        _pulse = Math.Min(_steps + Pulse, Math.Min(_limits.MaxSteps, long.MaxValue - 1) + 1);
    }

    private void Weigh()
    {
        if (Turtle.StackDepth > _limits.MaxStates)
        {
            throw Error(_current, "turtle.too_many_states",
                $"The program was stopped with {Text(_limits.MaxStates)} pushed states. Is there a push without a pop?");
        }
        if (_limits.Memory.Refuse(Bytes, "What the program has drawn and stored") is { } refusal) throw Error(_current, refusal.Code, refusal.Message);
    }

    private int Slot(Instruction at) => at.Local ? _context.Base + at.Slot : at.Slot;

    private void Command(Instruction at)
    {
        var arguments = at.Arguments;
        for (var i = 0; i < arguments.Length; i++) _numbers[i] = arguments[i] is { } argument ? Number(argument) : double.NaN;
        var moves = Turtle.MoveCount;
        if (moves >= _limits.MaxMoves) throw TooManyMoves(at);
        Turtle.At(_file, at.Line);
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
            ? "The value is not a number: 0 / 0, a root or logarithm of a negative number, or randint(from, to) with no integer between the two."
            : "The value is infinite: a division by zero, or a number too large.";
        throw new FormulaException("turtle.not_finite", message, argument.Line, argument.Column);
    }

    private double Integer(Argument argument, double low, double high)
    {
        var value = Number(argument);
        if (value >= low && value <= high && value == Math.Floor(value)) return value;
        throw new FormulaException("turtle.value",
            $"Found {NumberFormatter.Format(value, 6)}, expected an integer from {NumberFormatter.Format(low, 0)} to {NumberFormatter.Format(high, 0)}.",
            argument.Line, argument.Column);
    }

    private void SetElement(Instruction at)
    {
        var array = _context.Arrays[at.Slot] ?? throw Error(at, "turtle.index", $"The array '{at.Name}' has not been created yet.");
        var index = ScriptScope.Index(Number(at.Arguments[0]!), array.Length, at.Name, at.Line, at.Column);
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
        if (step == 0) throw new FormulaException("turtle.value", "The step of a loop must not be 0.", at.Arguments[2]!.Line, at.Arguments[2]!.Column);
        // Slightly more, so that 0 to 1 step 0.1 has its 11 iterations.
        var count = Math.Floor((to - from) / step + 1e-9) + 1;
        if (!(count > 0)) return false;
        var slot = Slot(at);
        StartLoop(slot, count);
        _context.Values[slot + 2] = from;
        _context.Values[slot + 3] = step;
        return true;
    }

    private bool NextTurn(int slot) => ++_context.Values[slot] < _context.Values[slot + 1];

    private string TextOf(TextTemplate template)
    {
        if (template.Values.Count == 0) return template.Texts[0];
        var text = new StringBuilder();
        for (var i = 0; i < template.Values.Count; i++) text.Append(template.Texts[i]).Append(NumberFormatter.Format(Number(template.Values[i]), 6));
        return text.Append(template.Texts[template.Values.Count]).ToString();
    }

    private static string Text(long number) => NumberFormatter.Format(number);

    private static FormulaException Error(Instruction at, string code, string message) => new(code, message, at.Line, at.Column);
}
