using System.Collections.Generic;
using System.Linq;
using Caterpillar.Expressions;

namespace Caterpillar.Turtles;

// Loops, choices, variables and procedures.
internal sealed partial class ScriptCompiler
{
    private void Repeat(Token token)
    {
        var count = Formula("repeat");
        var (slot, local) = _scope.Hidden(2);
        var start = Emit(new Instruction(ScriptOp.RepeatStart, token) { Slot = slot, Local = local, Arguments = [count] });
        _scope.Repeats.Push((slot, local));
        Loop(token, start, new Instruction(ScriptOp.RepeatNext, token) { Slot = slot, Local = local });
        _scope.Repeats.Pop();
    }

    // for i = from to end [step s] [ … ]
    private void For(Token token)
    {
        var name = Next;
        if (name.Kind != TokenKind.Name) throw Error("turtle.syntax", "'for' needs a variable: for i = 1 to 10 [ … ].", name);
        _at++;
        if (!Next.Is("=")) throw Error("turtle.syntax", $"Found {Next}, expected '=': for {name.Text} = 1 to 10 [ … ].", Next);
        _at++;
        var from = Formula("=");
        if (!Next.IsWord("to")) throw Error("turtle.syntax", $"Found {Next}, expected 'to': for {name.Text} = 1 to 10 [ … ].", Next);
        _at++;
        var to = Formula("to");
        Argument? step = null;
        if (Next.IsWord("step"))
        {
            _at++;
            step = Formula("step");
        }
        var (slot, local) = _scope.DeclareHere(name.Text);
        var (hidden, _) = _scope.Hidden(4);
        var start = Emit(new Instruction(ScriptOp.ForStart, token) { Slot = hidden, Local = local, Arguments = [from, to, step], Name = name.Text });
        // The variable's own slot is the first target of both instructions.
        Loop(token, start, new Instruction(ScriptOp.ForNext, token) { Slot = hidden, Local = local }, slot);
    }

    // start: loops or leaves; body; next: continues after start while there are iterations left.
    private void Loop(Token token, Instruction start, Instruction next, int variable = -1)
    {
        var body = _code.Count;
        if (variable >= 0)
        {
            Emit(new Instruction(ScriptOp.Set, token) { Slot = variable, Local = start.Local, Arguments = [new Argument(LoopValue(start), token)] });
        }
        _breaks.Push(new Leaving(_shapings.Count));
        Block();
        next.Target = body;
        Emit(next);
        start.Target = _code.Count;
        foreach (var jump in _breaks.Pop().Jumps) jump.Target = _code.Count;
    }

    // from + turn * step, so that long loops do not drift.
    private static FormulaNode LoopValue(Instruction start)
    {
        var slot = start.Slot;
        return start.Local
            ? new FormulaNode(c => c.Values[c.Base + slot + 2] + c.Values[c.Base + slot] * c.Values[c.Base + slot + 3])
            : new FormulaNode(c => c.Values[slot + 2] + c.Values[slot] * c.Values[slot + 3]);
    }

    private void If(Token token)
    {
        var condition = Formula("if");
        var otherwise = Emit(new Instruction(ScriptOp.JumpIfFalse, token) { Arguments = [condition] });
        Block();
        var mark = _at;
        SkipLines();
        if (!Next.IsWord("else"))
        {
            _at = mark;
            otherwise.Target = _code.Count;
            return;
        }
        var end = Emit(new Instruction(ScriptOp.Jump, Next));
        otherwise.Target = _code.Count;
        _at++;
        SkipLines();
        if (Next.IsWord("if"))
        {
            var next = Next;
            _at++;
            if (++_nesting > MaxNesting) throw Error("turtle.nesting", "Too many 'else if' in a row.", next);
            If(next);
            _nesting--;
        }
        else
        {
            Block();
        }
        end.Target = _code.Count;
    }

    private void While(Token token)
    {
        var start = _code.Count;
        var condition = Formula("while");
        var leave = Emit(new Instruction(ScriptOp.JumpIfFalse, token) { Arguments = [condition] });
        _breaks.Push(new Leaving(_shapings.Count));
        Block();
        Emit(new Instruction(ScriptOp.Jump, token) { Target = start });
        leave.Target = _code.Count;
        foreach (var jump in _breaks.Pop().Jumps) jump.Target = _code.Count;
    }

    private void Break(Token token)
    {
        if (_breaks.Count == 0) throw Error("turtle.syntax", "'break' is only allowed in a loop.", token);
        CloseShapings(_breaks.Peek().Shapings, token);
        _breaks.Peek().Jumps.Add(Emit(new Instruction(ScriptOp.Jump, token)));
    }

    private void Define(Token token)
    {
        if (_nesting > _outermost || _scope.InProcedure) throw Error("turtle.syntax", "Procedures must be defined outside of blocks.", token);
        if (Next.Kind != TokenKind.Name) throw Error("turtle.syntax", "'def' needs a name: def square side [ … ].", Next);
        var procedure = _procedures[Next.Text];
        while (Next.Kind == TokenKind.Name || Next.Is(",")) _at++;
        var over = Emit(new Instruction(ScriptOp.Jump, token));
        procedure.Start = _code.Count;
        _scope.Enter(procedure.Parameters);
        Block();
        procedure.FrameSize = _scope.LocalCount;
        _scope.Leave();
        Emit(new Instruction(ScriptOp.Return, token));
        over.Target = _code.Count;
    }

    private void Let(Token token)
    {
        var name = Next;
        if (name.Kind != TokenKind.Name) throw Error("turtle.syntax", "'let' needs a name: let side = 10.", name);
        _at++;
        if (!Next.Is("=")) throw Error("turtle.syntax", $"Found {Next}, expected '=': let {name.Text} = 10.", Next);
        Assign(name, declare: true);
    }

    private void Assign(Token name, bool declare)
    {
        var op = Next;
        _at++;
        if (_scope.IsArray(name.Text)) throw Error("turtle.name", $"'{name.Text}' is an array; use {name.Text}[index] = ….", name);
        if (_procedures.ContainsKey(name.Text)) throw Error("turtle.name", $"'{name.Text}' is a procedure.", name);
        var before = op.Text == "=" ? null : _scope.Variable(name.Text, name)
            ?? throw Error("turtle.unknown", $"There is no variable '{name.Text}'.{SpellingSuggestion.Hint(name.Text, _scope.Names)}", name);
        var value = Formula(op.Text);
        if (before is not null)
        {
            var node = FormulaNode.Binary(op.Text.Substring(0, 1), before, new FormulaNode(value.Evaluate, 2));
            value = new Argument(node, name);
        }
        var (slot, local) = declare ? _scope.DeclareHere(name.Text) : _scope.ForAssignment(name.Text);
        Emit(new Instruction(ScriptOp.Set, name) { Slot = slot, Local = local, Arguments = [value], Name = name.Text });
    }

    // The jumps out of a loop, and the shaping blocks around it.
    private sealed class Leaving(int shapings)
    {
        public int Shapings { get; } = shapings;

        public List<Instruction> Jumps { get; } = [];
    }

    // param side = 10: a value set from outside takes precedence.
    private void Param(Token token)
    {
        var name = Next;
        if (name.Kind != TokenKind.Name
            || _scope.InProcedure)
        {
            throw Error("turtle.syntax", "'param' needs a name and must be outside of procedures: param side = 10.", name);
        }
        _at++;
        if (!Next.Is("=")) throw Error("turtle.syntax", $"Found {Next}, expected '=': param {name.Text} = 10.", Next);
        _at++;
        var value = Formula("=");
        if (!_parameters.Contains(name.Text)) _parameters.Add(name.Text);
        Emit(new Instruction(ScriptOp.Parameter, token) { Slot = _scope.DeclareGlobal(name.Text), Arguments = [value], Name = name.Text });
    }

    private void NewArray(Token token)
    {
        var name = Next;
        if (name.Kind != TokenKind.Name) throw Error("turtle.syntax", "'array' needs a name and a size: array cells 50.", name);
        _at++;
        Emit(new Instruction(ScriptOp.NewArray, token) { Slot = _scope.ArraySlot(name.Text), Arguments = [Formula(name.Text)], Name = name.Text });
    }

    private void SetElement(Token name)
    {
        _at++;
        var index = Formula("[");
        if (!Next.Is("]")) throw Error("turtle.bracket", $"Found {Next}, expected ']'.", Next);
        _at++;
        if (!Next.Is("=")) throw Error("turtle.syntax", $"Found {Next}, expected '='.", Next);
        _at++;
        Emit(new Instruction(ScriptOp.SetElement, name) { Slot = _scope.ArraySlot(name.Text), Arguments = [index, Formula("=")], Name = name.Text });
    }

    // use "printer" ["material"] ["settings"]
    private void Use(Token token)
    {
        const string Usage = "use \"printer\" [\"material\"] [\"settings\"]";
        NotInBlock(token);
        if (_profiles.Count > 0) throw Error("turtle.syntax", "There is a 'use' already; a script is for one printer.", token);
        for (; Next.Kind == TokenKind.Text && _profiles.Count < 3; _at++) _profiles.Add(Next.Text);
        if (_profiles.Count == 0 || !EndsStatement(Next)) throw Error("turtle.values", $"'use' needs one to three texts: {Usage}.", token);
    }

    // lsystem generations "axiom" "rule" …
    private void Grow(Token token)
    {
        var generations = Value("lsystem", "lsystem generations \"axiom\" \"rule\" …");
        var texts = new List<Token>();
        while (Next.Kind is TokenKind.Text or TokenKind.NewLine or TokenKind.Symbol)
        {
            if (Next.Kind == TokenKind.Text) texts.Add(Next);
            // Rules may be on lines of their own.
            else if (Next.Kind != TokenKind.NewLine || _tokens[_at + 1].Kind is not (TokenKind.Text or TokenKind.NewLine)) break;
            _at++;
        }
        if (texts.Count == 0) throw Error("turtle.values", "'lsystem' needs an axiom: lsystem 5 \"F\" \"F -> F+F--F+F\".", token);
        var variables = _scope.Variables;
        var system = LSystem.Parse(texts[0].Text, texts.Skip(1).Select(t => t.Text), variables.Select(v => v.Name).ToArray());
        if (system.Value is null)
        {
            var problem = system.Diagnostics[0];
            var text = texts[problem.Source?.Line ?? 0];
            throw new FormulaException(problem.Code, problem.Message, text.Line, text.Column + (problem.Source?.Column ?? 1));
        }
        var grow = Emit(new Instruction(ScriptOp.Grow, token) { System = system.Value, Variables = variables, Arguments = [generations] });
        Emit(new Instruction(ScriptOp.NextLetter, token));
        grow.Target = _code.Count;
    }

    private TextTemplate Template(Token token)
    {
        var texts = new List<string>();
        var values = new List<Argument>();
        var text = token.Text;
        var from = 0;
        while (true)
        {
            var open = text.IndexOf("{", from, System.StringComparison.Ordinal);
            var close = open < 0 ? -1 : text.IndexOf("}", open, System.StringComparison.Ordinal);
            if (close < 0)
            {
                texts.Add(text.Substring(from));
                return new TextTemplate(texts, values);
            }
            texts.Add(text.Substring(from, open - from));
            try
            {
                var parser = new FormulaParser(Lexer.Read(text.Substring(open + 1, close - open - 1)), 0, _scope);
                values.Add(new Argument(parser.Parse(), token));
                parser.ExpectEnd();
            }
            catch (FormulaException e)
            {
                throw new FormulaException(e.Code, e.Message, token.Line, token.Column + 1 + open + e.Column);
            }
            from = close + 1;
        }
    }
}
