using System;
using System.Collections.Generic;
using System.Text;
using System.Threading;
using Caterpillar.Basics;
using Caterpillar.Expressions;

namespace Caterpillar.Turtles;

/// <summary>Runs a compiled script with a stack of its own, so that deep recursion ends at a limit and does not overflow the thread's stack.</summary>
internal sealed class ScriptMachine
{
    private readonly ScriptCode _code;
    private readonly Turtle _turtle;
    private readonly TurtleLimits _limits;
    private readonly IReadOnlyDictionary<string, double> _given;
    private readonly FormulaContext _context;
    private readonly List<Frame> _frames = [];
    private readonly List<Letters> _words = [];
    private readonly double[] _numbers = new double[4];
    private LSystemInterpretation? _standard;
    private double _standardStep;
    private double _standardAngle;
    private int _frameSize;

    public ScriptMachine(ScriptCode code, Turtle turtle, TurtleLimits limits, IReadOnlyDictionary<string, double> given, int seed)
    {
        _code = code;
        _turtle = turtle;
        _limits = limits;
        _given = given;
        _frameSize = code.GlobalCount;
        _context = new FormulaContext(new double[Math.Max(64, code.GlobalCount)], new SeededRandom(seed)) { Host = turtle,
            Arrays = new double[]?[code.ArrayCount] };
        for (var i = 0; i < _frameSize; i++) _context.Values[i] = double.NaN;
    }

    /// <summary>What was noticed while it ran.</summary>
    public DiagnosticList Remarks { get; } = new();

    /// <exception cref="FormulaException">The program failed.</exception>
    public void Run(CancellationToken cancel)
    {
        var code = _code.Instructions;
        var pc = 0;
        var steps = 0L;
        while (true)
        {
            var at = code[pc];
            if (++steps > _limits.MaxSteps) throw Error(at, "turtle.endless",
                $"The program was stopped after {Text(_limits.MaxSteps)} steps. Does a loop never end?");
            if ((steps & 0x3FFF) == 0) cancel.ThrowIfCancellationRequested();
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
                    _context.Arrays[at.Slot] = new double[Size(at)];
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
                    pc = Return();
                    break;
                case ScriptOp.Grow:
                    _words.Add(new Letters(Grow(at, cancel)));
                    break;
                case ScriptOp.NextLetter:
                    pc = NextLetter(at, pc);
                    break;
                default:
                    return;
            }
        }
    }

    private int Slot(Instruction at) => at.Local ? _context.Base + at.Slot : at.Slot;

    private void Command(Instruction at)
    {
        var arguments = at.Arguments;
        for (var i = 0; i < arguments.Length; i++) _numbers[i] = arguments[i] is { } argument ? Number(argument) : double.NaN;
        if (_turtle.MoveCount >= _limits.MaxMoves) throw Error(at, "turtle.too_many_moves", $"The program was stopped after {Text(_limits.MaxMoves)} moves.");
        try
        {
            TurtleCommand.Apply(_turtle, at.Action, arguments.Length, _numbers[0], _numbers[1], _numbers[2], _numbers[3], at.Text is null ? ""
                : TextOf(at.Text));
        }
        catch (Exception e) when (e is ArgumentException or InvalidOperationException)
        {
            throw Error(at, "turtle.value", $"'{at.Name}': {Messages.Clean(e)}");
        }
    }

    private double Number(Argument argument)
    {
        var value = argument.Evaluate(_context);
        if (!double.IsNaN(value - value)) return value;
        var message = double.IsNaN(value)
            ? "The value is not a number: 0 / 0, or a root or logarithm of a negative number."
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

    private int Size(Instruction at) => (int)Integer(at.Arguments[0]!, 0, _limits.MaxSymbols);

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

    private void Call(Instruction at, int back)
    {
        var procedure = at.Procedure!;
        var values = Enter(procedure, at, back, out var start);
        // Formulas still see the caller's variables; the new frame comes after them.
        for (var i = 0; i < at.Arguments.Length; i++)
        {
            var value = Number(at.Arguments[i]!);
            values[start + i] = value;
        }
        _context.Base = start;
        _frameSize = procedure.FrameSize;
    }

    private double[] Enter(Procedure procedure, Instruction at, int back, out int start)
    {
        if (_frames.Count >= _limits.MaxDepth) throw Error(at, "turtle.recursion",
            $"Procedures call each other {Text(_limits.MaxDepth)} levels deep. Does a recursion never end?");
        start = _context.Base + _frameSize;
        _frames.Add(new Frame(back, _context.Base, _frameSize, _words.Count));
        var values = _context.Values;
        if (start + procedure.FrameSize > values.Length)
        {
            Array.Resize(ref values, 2 * (start + procedure.FrameSize));
            _context.Values = values;
        }
        for (var i = start; i < start + procedure.FrameSize; i++) values[i] = double.NaN;
        return values;
    }

    private int Return()
    {
        var frame = _frames[_frames.Count - 1];
        _frames.RemoveAt(_frames.Count - 1);
        _context.Base = frame.Base;
        _frameSize = frame.Size;
        _words.RemoveRange(frame.Words, _words.Count - frame.Words);
        return frame.Back;
    }

    private LSystemWord Grow(Instruction at, CancellationToken cancel)
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
        var result = at.System!.Grow(variables, generations, seed, _limits.MaxSymbols, null, cancel);
        if (result.Value is null) throw Error(at, result.Diagnostics[0].Code, result.Diagnostics[0].Message);
        foreach (var remark in result.Diagnostics) Remarks.Add(remark with { Source = new SourceLocation(Line: at.Line, Column: at.Column) });
        return result.Value;
    }

    // One letter of the word on top; a procedure of its name returns here.
    private int NextLetter(Instruction at, int pc)
    {
        var letters = _words[_words.Count - 1];
        if (letters.At >= letters.Word.Count)
        {
            _words.RemoveAt(_words.Count - 1);
            return pc;
        }
        var index = letters.At++;
        var word = letters.Word;
        if (_code.Letters.TryGetValue(word[index], out var procedure))
        {
            if (word.ValueCount(index) != procedure.Parameters.Count)
                throw Error(at, "lsystem.value",
                    $"The letter '{word[index]}' has {Text(word.ValueCount(index))} values, its procedure {Text(procedure.Parameters.Count)}.");
            var values = Enter(procedure, at, pc - 1, out var start);
            for (var v = 0; v < procedure.Parameters.Count; v++) values[start + v] = word.Value(index, v);
            _context.Base = start;
            _frameSize = procedure.FrameSize;
            return procedure.Start;
        }
        if (_turtle.MoveCount >= _limits.MaxMoves) throw Error(at, "turtle.too_many_moves", $"The program was stopped after {Text(_limits.MaxMoves)} moves.");
        try
        {
            Standard().Apply(_turtle, word, index);
        }
        catch (Exception e) when (e is ArgumentException or InvalidOperationException)
        {
            throw Error(at, e is InvalidOperationException ? "lsystem.bracket"
                : "lsystem.value", $"Letter {Text(index + 1)} ('{word[index]}') of the word: {Messages.Clean(e)}");
        }
        return pc - 1;
    }

    private LSystemInterpretation Standard()
    {
        var step = _code.StepSlot < 0 || double.IsNaN(_context.Values[_code.StepSlot]) ? 1 : _context.Values[_code.StepSlot];
        var angle = _code.AngleSlot < 0 || double.IsNaN(_context.Values[_code.AngleSlot]) ? 90 : _context.Values[_code.AngleSlot];
        if (_standard is null || step != _standardStep || angle != _standardAngle) _standard = LSystemInterpretation.Standard(step, angle);
        (_standardStep, _standardAngle) = (step, angle);
        return _standard;
    }

    private string TextOf(TextTemplate template)
    {
        if (template.Values.Count == 0) return template.Texts[0];
        var text = new StringBuilder();
        for (var i = 0; i < template.Values.Count; i++) text.Append(template.Texts[i]).Append(NumberFormatter.Format(Number(template.Values[i]), 6));
        return text.Append(template.Texts[template.Values.Count]).ToString();
    }

    private static string Text(long number) => NumberFormatter.Format(number);

    private static FormulaException Error(Instruction at, string code, string message) => new(code, message, at.Line, at.Column);

    private readonly record struct Frame(int Back, int Base, int Size, int Words);

    private sealed class Letters(LSystemWord word)
    {
        public LSystemWord Word { get; } = word;

        public int At { get; set; }
    }
}
