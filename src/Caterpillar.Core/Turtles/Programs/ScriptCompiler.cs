using static Caterpillar.Turtles.ScriptCursor;

namespace Caterpillar.Turtles;

/// <summary>Reads a script once and turns it into instructions.</summary>
internal sealed class ScriptCompiler
{
    private readonly ScriptCursor _cursor;
    private readonly ScriptNames _names;
    private readonly ScriptScope _scope;
    private readonly ScriptValues _values;
    private readonly ScriptFlow _flow;
    private readonly List<string> _parameters = [];
    private readonly List<string> _profiles = [];
    private int _outermost = 1;

    private ScriptCompiler(ScriptSource source)
    {
        _cursor = new ScriptCursor(source);
        _names = new ScriptNames(_cursor);
        _scope = _names.Scope;
        _values = new ScriptValues(_cursor, _names);
        _flow = new ScriptFlow(_cursor, _values, _scope, Block);
    }

    private Token Next => _cursor.Next;

    /// <exception cref="FormulaException">The text is not a program.</exception>
    public static ScriptCode Compile(string text, string? file, ScriptFiles files) => new ScriptCompiler(ScriptSource.Read(text, file, files)).Compile();

    private ScriptCode Compile()
    {
        Statements(end: null);
        _flow.Emit(new Instruction(ScriptOp.Stop, Next));
        return new ScriptCode
        {
            Instructions = _flow.ToArray(),
            GlobalCount = _scope.GlobalCount,
            ArrayCount = _scope.ArrayCount,
            CallsFunctions = _scope.CallsFunctions,
            Parameters = _parameters,
            Profiles = _profiles,
            Letters = _names.Procedures.Values.Where(p => p.Name.Length == 1).ToDictionary(p => p.Name[0]),
            StepSlot = _scope.GlobalSlot("step_length"),
            AngleSlot = _scope.GlobalSlot("turn_angle"),
        };
    }

    private void Statements(Token? end)
    {
        if (++_flow.Nesting > ScriptFlow.MaxNesting)
            throw Error("turtle.nesting", $"Blocks are nested more than {NumberFormatter.Format(ScriptFlow.MaxNesting)} levels deep.", Next);
        while (true)
        {
            while (Next.Kind == TokenKind.NewLine || Next.Is(";")) _cursor.At++;
            if (Next.Kind == TokenKind.End)
            {
                if (end is { } open) throw Error("turtle.bracket", "'[' has no closing ']'.", open);
                break;
            }
            if (Next.Is("]"))
            {
                if (end is null) throw Error("turtle.bracket", "']' has no matching '['.", Next);
                _cursor.At++;
                break;
            }
            Statement();
        }
        _flow.Nesting--;
    }

    private void Block()
    {
        _cursor.SkipLines();
        var open = Next;
        _cursor.Expect("[");
        Statements(open);
    }

    private void Statement()
    {
        var token = Next;
        if (token.Kind != TokenKind.Name) throw Error("turtle.syntax", $"Found {token}, expected a command.", token);
        _cursor.At++;
        switch (token.Text)
        {
            case "repeat": _flow.Repeat(token); return;
            case "for": _flow.For(token); return;
            case "if": _flow.If(token); return;
            case "while": _flow.While(token); return;
            case "break": _flow.Break(token); return;
            case "def": Define(token); return;
            case "let": Let(); return;
            case "param": Param(token); return;
            case "array": NewArray(token); return;
            case "seed": _flow.Emit(new Instruction(ScriptOp.Seed, token) { Arguments = [_values.Value("seed", "a number")] }); return;
            case "return": Return(token); return;
            case "stop": _flow.Emit(new Instruction(ScriptOp.Stop, token)); return;
            case "print": Print(token); return;
            case "include": Include(token); return;
            case "image": Image(token); return;
            case "deform" or "modulate" or "gap_bead" or "cool_layers": _flow.Shape(token); return;
            case "lsystem": Grow(token); return;
            case "use": Use(token); return;
        }
        if (Next.Kind == TokenKind.Symbol && Next.Text is "=" or "+=" or "-=" or "*=" or "/=") Assign(token, declare: false);
        else if (Next.Is("[") && !Next.SpaceBefore && _scope.IsArray(token.Text)) SetElement(token);
        else if (_names.Procedures.TryGetValue(token.Text, out var procedure)) Call(token, procedure);
        else if (TurtleCommands.Find(token.Text) is { } info) Command(token, info);
        else throw _names.Unknown(token);
    }

    private void Call(Token token, Procedure procedure)
    {
        var usage = $"'{string.Join(" ", new[] { procedure.Name }.Concat(procedure.Parameters))}'";
        var arguments = _values.OfCall(procedure.Parameters.Count, token, usage);
        _flow.Emit(new Instruction(ScriptOp.Call, token) { Procedure = procedure, Arguments = arguments });
    }

    private void Command(Token token, TurtleCommandInfo info)
    {
        TextTemplate? text = null;
        if (info.Text is not null && Next.Kind == TokenKind.Text) text = _values.Template(_cursor.Tokens[_cursor.At++]);
        else if (info.Text is not null && !info.Text.StartsWith("[", System.StringComparison.Ordinal))
            throw Error("turtle.values", $"'{token.Text}' needs a text: {info.Usage}.", EndsStatement(Next) ? token : Next);
        var arguments = _values.Values(text is null ? info.Required : 0, info.Values.Count, info.MayKeep, token, $"'{info.Usage}'");
        _flow.Emit(new Instruction(ScriptOp.Command, token) { Action = info.Action, Arguments = arguments, Text = text, Name = token.Text });
    }

    private void Define(Token token)
    {
        if (IsInBlock) throw Error("turtle.syntax", "Procedures must be defined outside blocks.", token);
        var procedure = _names.Procedures[_cursor.TakeName("'def' needs a name: def square side [ … ].").Text];
        while (Next.Kind == TokenKind.Name || Next.Is(",")) _cursor.At++;
        var over = _flow.Emit(new Instruction(ScriptOp.Jump, token));
        procedure.Start = _flow.Count;
        _scope.Enter(procedure.Parameters);
        Block();
        procedure.FrameSize = _scope.LocalCount;
        _scope.Leave();
        _flow.Emit(new Instruction(ScriptOp.Return, token));
        over.Target = _flow.Count;
    }

    private void Return(Token token)
    {
        var hasValue = _names.IsValueAfterReturn(_cursor.At);
        if (hasValue && !_scope.InProcedure) throw Error("turtle.syntax", "'return' with a value is only allowed in a procedure.", token);
        Argument[] value = hasValue ? [_values.Formula("return")] : [];
        if (hasValue && !EndsStatement(Next)) throw Error("turtle.values", $"Found {Next}, expected the end of the value.", Next);
        _flow.CloseShapings(0, token);
        _flow.Emit(new Instruction(_scope.InProcedure ? ScriptOp.Return : ScriptOp.Stop, token) { Arguments = value });
    }

    private void Let()
    {
        var name = _cursor.TakeName("'let' needs a name: let side = 10.");
        if (!Next.Is("=")) throw Error("turtle.syntax", $"Found {Next}, expected '=': let {name.Text} = 10.", Next);
        Assign(name, declare: true);
    }

    private void Assign(Token name, bool declare)
    {
        var op = Next;
        _cursor.At++;
        if (_scope.IsArray(name.Text)) throw Error("turtle.name", $"'{name.Text}' is an array. Use {name.Text}[index] = ….", name);
        if (_names.Procedures.ContainsKey(name.Text)) throw Error("turtle.name", $"'{name.Text}' is a procedure. Choose another name for the variable.", name);
        var before = op.Text == "=" ? null : _scope.Variable(name.Text, name)
            ?? throw Error("turtle.unknown", $"Unknown variable '{name.Text}'.{SpellingSuggestion.Hint(name.Text, _scope.Names)}", name);
        var value = _values.Formula(op.Text);
        if (before is not null)
        {
            var node = FormulaNode.Binary(op.Text.Substring(0, 1), before, new FormulaNode(value.Evaluate, 2));
            value = new Argument(node, name);
        }
        var (slot, local) = declare ? _scope.DeclareHere(name.Text) : _scope.ForAssignment(name.Text);
        _flow.Emit(new Instruction(ScriptOp.Set, name) { Slot = slot, Local = local, Arguments = [value], Name = name.Text });
    }

    // param side = 10: a value set from outside takes precedence.
    private void Param(Token token)
    {
        const string Usage = "'param' needs a name and must be outside procedures: param side = 10.";
        if (_scope.InProcedure) throw Error("turtle.syntax", Usage, Next);
        var name = _cursor.TakeName(Usage);
        _cursor.Expect("=", $"param {name.Text} = 10");
        var value = _values.Formula("=");
        if (!_parameters.Contains(name.Text)) _parameters.Add(name.Text);
        _flow.Emit(new Instruction(ScriptOp.Parameter, token) { Slot = _scope.DeclareGlobal(name.Text), Arguments = [value], Name = name.Text });
    }

    private void NewArray(Token token)
    {
        var name = _cursor.TakeName("'array' needs a name and a size: array cells 50.");
        var slot = _scope.ArraySlot(name.Text);
        _flow.Emit(new Instruction(ScriptOp.NewArray, token) { Slot = slot, Arguments = [_values.Formula(name.Text)], Name = name.Text });
    }

    private void SetElement(Token name)
    {
        _cursor.At++;
        var index = _values.Formula("[");
        _cursor.Expect("]", code: "turtle.bracket");
        _cursor.Expect("=");
        var slot = _scope.ArraySlot(name.Text);
        _flow.Emit(new Instruction(ScriptOp.SetElement, name) { Slot = slot, Arguments = [index, _values.Formula("=")], Name = name.Text });
    }

    // print "text" value …: texts and values, separated by spaces.
    private void Print(Token token)
    {
        const string Usage = "print \"text\" value …";
        var texts = new List<string> { "" };
        var values = new List<Argument>();
        var first = true;
        while (!EndsStatement(Next))
        {
            if (Next.Is(",") && !first) _cursor.At++;
            if (Next.Kind != TokenKind.Text && !_values.BeginsValue(Next)) break;
            if (!first) texts[texts.Count - 1] += " ";
            first = false;
            if (Next.Kind != TokenKind.Text)
            {
                values.Add(_values.Value("print", Usage));
                texts.Add("");
                continue;
            }
            var template = _values.Template(_cursor.Tokens[_cursor.At++]);
            texts[texts.Count - 1] += template.Texts[0];
            values.AddRange(template.Values);
            texts.AddRange(template.Texts.Skip(1));
        }
        if (!EndsStatement(Next) && Next.Kind != TokenKind.Name)
            throw Error("turtle.values", $"Found {Next}, expected a text, a value or the end of the line.", Next);
        if (first && !EndsStatement(Next) && !_names.BeginsStatement(Next)) _values.Value("print", Usage);
        _flow.Emit(new Instruction(ScriptOp.Print, token) { Text = new TextTemplate(texts, values) });
    }

    // include "file": its statements run here, the first time that a file is included.
    private void Include(Token token)
    {
        const string Usage = "include \"file\"";
        if (Next.Kind != TokenKind.Text) throw Error("turtle.values", $"'include' needs a file name: {Usage}.", token);
        NotInBlock(token);
        var name = _cursor.At++;
        _cursor.ExpectEnd(Usage);
        if (!_cursor.Source.Includes.TryGetValue(name, out var source) || source is null) return;
        var outermost = _outermost;
        _outermost = _flow.Nesting + 1;
        _cursor.Within(source, () => Statements(end: null));
        _outermost = outermost;
    }

    // image name "file" [smooth]: a function of two numbers, which is declared already.
    private void Image(Token token)
    {
        const string Usage = "image name \"file\" [smooth]";
        NotInBlock(token);
        if (Next.Kind != TokenKind.Name || !_cursor.Source.Images.ContainsKey(_cursor.At + 1))
            throw Error("turtle.values", $"'image' needs a name and a file name: {Usage}.", token);
        _cursor.At += 2;
        if (_names.IsSmooth(_cursor.At)) _cursor.At++;
        _cursor.ExpectEnd(Usage);
    }

    // use "printer" ["material"] ["settings"]
    private void Use(Token token)
    {
        const string Usage = "use \"printer\" [\"material\"] [\"settings\"]";
        NotInBlock(token);
        if (_profiles.Count > 0) throw Error("turtle.syntax", "The script already has a 'use'. A script is for one printer.", token);
        for (; Next.Kind == TokenKind.Text && _profiles.Count < 3; _cursor.At++) _profiles.Add(Next.Text);
        if (_profiles.Count == 0 || !EndsStatement(Next)) throw Error("turtle.values", $"'use' needs one to three texts: {Usage}.", token);
    }

    // lsystem generations "axiom" "rule" …
    private void Grow(Token token)
    {
        var generations = _values.Value("lsystem", "lsystem generations \"axiom\" \"rule\" …");
        var texts = new List<Token>();
        while (Next.Kind is TokenKind.Text or TokenKind.NewLine or TokenKind.Symbol)
        {
            if (Next.Kind == TokenKind.Text) texts.Add(Next);
            // Rules may be on lines of their own.
            else if (Next.Kind != TokenKind.NewLine || _cursor.Tokens[_cursor.At + 1].Kind is not (TokenKind.Text or TokenKind.NewLine)) break;
            _cursor.At++;
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
        var grow = _flow.Emit(new Instruction(ScriptOp.Grow, token) { System = system.Value, Variables = variables, Arguments = [generations] });
        _flow.Emit(new Instruction(ScriptOp.NextLetter, token));
        grow.Target = _flow.Count;
    }

    private bool IsInBlock => _flow.Nesting > _outermost || _scope.InProcedure;

    private void NotInBlock(Token token)
    {
        if (IsInBlock) throw Error("turtle.syntax", $"'{token.Text}' must not be inside a block.", token);
    }
}
