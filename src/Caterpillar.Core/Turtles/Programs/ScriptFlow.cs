using static Caterpillar.Turtles.ScriptCursor;

namespace Caterpillar.Turtles;

/// <summary>The instructions of a script while it is compiled, and its loops, choices and shaping blocks.</summary>
/// <param name="cursor">The position of the compiler.</param>
/// <param name="values">Reads formulas.</param>
/// <param name="scope">The names of the script.</param>
/// <param name="block">Compiles the block that comes next.</param>
internal sealed class ScriptFlow(ScriptCursor cursor, ScriptValues values, ScriptScope scope, Action block)
{
    /// <summary>Maximum nesting depth of blocks. Each 'else if' counts as one.</summary>
    public const int MaxNesting = 200;

    private readonly List<Instruction> _code = [];
    private readonly Stack<Leaving> _breaks = new();

    // The shaping blocks that are open, the innermost last.
    private readonly List<ShapingRules> _shapings = [];

    /// <summary>Number of blocks around the current position.</summary>
    public int Nesting { get; set; }

    /// <summary>Number of instructions so far.</summary>
    public int Count => _code.Count;

    public Instruction[] ToArray() => _code.ToArray();

    public Instruction Emit(Instruction instruction)
    {
        instruction.File = cursor.Source.File;
        _code.Add(instruction);
        return instruction;
    }

    // repeat count [ … ]
    public void Repeat(Token token)
    {
        var count = values.Formula("repeat");
        var (slot, local) = scope.Hidden(2);
        var start = Emit(new Instruction(ScriptOp.RepeatStart, token) { Slot = slot, Local = local, Arguments = [count] });
        scope.Repeats.Push((slot, local));
        Loop(token, start, new Instruction(ScriptOp.RepeatNext, token) { Slot = slot, Local = local });
        scope.Repeats.Pop();
    }

    // for i = from to end [step s] [ … ]
    public void For(Token token)
    {
        var name = cursor.TakeName("'for' needs a variable: for i = 1 to 10 [ … ].");
        var example = $"for {name.Text} = 1 to 10 [ … ]";
        cursor.Expect("=", example);
        var from = values.Formula("=");
        cursor.Expect("to", example);
        var to = values.Formula("to");
        Argument? step = null;
        if (cursor.Next.IsWord("step"))
        {
            cursor.At++;
            step = values.Formula("step");
        }
        var (slot, local) = scope.DeclareHere(name.Text);
        var (hidden, _) = scope.Hidden(4);
        var start = Emit(new Instruction(ScriptOp.ForStart, token) { Slot = hidden, Local = local, Arguments = [from, to, step], Name = name.Text });
        // The variable's own slot is the first target of both instructions.
        Loop(token, start, new Instruction(ScriptOp.ForNext, token) { Slot = hidden, Local = local }, slot);
    }

    // if condition [ … ] else if … [ … ] else [ … ]
    public void If(Token token)
    {
        var condition = values.Formula("if");
        var otherwise = Emit(new Instruction(ScriptOp.JumpIfFalse, token) { Arguments = [condition] });
        block();
        var mark = cursor.At;
        cursor.SkipLines();
        if (!cursor.Next.IsWord("else"))
        {
            cursor.At = mark;
            otherwise.Target = _code.Count;
            return;
        }
        var end = Emit(new Instruction(ScriptOp.Jump, cursor.Next));
        otherwise.Target = _code.Count;
        cursor.At++;
        cursor.SkipLines();
        if (cursor.Next.IsWord("if"))
        {
            var next = cursor.Next;
            cursor.At++;
            if (++Nesting > MaxNesting) throw Error("turtle.nesting", "Too many 'else if' in a row.", next);
            If(next);
            Nesting--;
        }
        else
        {
            block();
        }
        end.Target = _code.Count;
    }

    // while condition [ … ]
    public void While(Token token)
    {
        var start = _code.Count;
        var condition = values.Formula("while");
        var leave = Emit(new Instruction(ScriptOp.JumpIfFalse, token) { Arguments = [condition] });
        _breaks.Push(new Leaving(_shapings.Count));
        block();
        Emit(new Instruction(ScriptOp.Jump, token) { Target = start });
        leave.Target = _code.Count;
        foreach (var jump in _breaks.Pop().Jumps) jump.Target = _code.Count;
    }

    public void Break(Token token)
    {
        if (_breaks.Count == 0) throw Error("turtle.syntax", "'break' is only allowed in a loop.", token);
        CloseShapings(_breaks.Peek().Shapings, token);
        _breaks.Peek().Jumps.Add(Emit(new Instruction(ScriptOp.Jump, token)));
    }

    /// <summary>A block that shapes the paths drawn in it.</summary>
    public void Shape(Token token)
    {
        var rules = new ShapingHeader(cursor, values, scope).Read(token);
        Emit(new Instruction(ScriptOp.BeginShaping, token) { Shaping = rules });
        _shapings.Add(rules);
        block();
        CloseShapings(_shapings.Count - 1, token);
        _shapings.RemoveAt(_shapings.Count - 1);
    }

    /// <summary>Ends all shaping blocks but a number of them, the innermost first. They stay open for the following statements.</summary>
    public void CloseShapings(int beyond, Token token)
    {
        for (var i = _shapings.Count - 1; i >= beyond; i--) Emit(new Instruction(ScriptOp.EndShaping, token) { Shaping = _shapings[i] });
    }

    // start: loops or leaves; body; next: continues after start while there are iterations left.
    private void Loop(Token token, Instruction start, Instruction next, int variable = -1)
    {
        var body = _code.Count;
        if (variable >= 0)
            Emit(new Instruction(ScriptOp.Set, token) { Slot = variable, Local = start.Local, Arguments = [new Argument(LoopValue(start), token)] });
        _breaks.Push(new Leaving(_shapings.Count));
        block();
        next.Target = body;
        Emit(next);
        start.Target = _code.Count;
        foreach (var jump in _breaks.Pop().Jumps) jump.Target = _code.Count;
    }

    // from + turn * step, so that long loops do not drift.
    private static FormulaNode LoopValue(Instruction start) => new(c =>
    {
        var slot = start.Local ? c.Base + start.Slot : start.Slot;
        return c.Values[slot + 2] + c.Values[slot] * c.Values[slot + 3];
    });

    // The jumps out of a loop, and the shaping blocks around it.
    private sealed class Leaving(int shapings)
    {
        public int Shapings { get; } = shapings;

        public List<Instruction> Jumps { get; } = [];
    }
}
