using System;
using System.Collections.Generic;
using System.Linq;
using Caterpillar.Expressions;

namespace Caterpillar.Turtles;

/// <summary>Reads a script once and turns it into instructions.</summary>
internal sealed partial class ScriptCompiler
{
    private const int MaxNesting = 200;

    private static readonly string[] Keywords =
    [
        "repeat", "for", "to", "step", "if", "else", "while", "break", "let", "param", "array", "seed", "def", "return", "stop", "lsystem", "use", "keep",
        "and", "or", "not",
    ];

    private readonly List<Token> _tokens;
    private readonly List<Instruction> _code = [];
    private readonly ScriptScope _scope = new();
    private readonly Dictionary<string, Procedure> _procedures = new(StringComparer.Ordinal);
    private readonly List<string> _parameters = [];
    private readonly Stack<List<Instruction>> _breaks = new();
    private readonly List<string> _profiles = [];
    private int _at;
    private int _nesting;

    private ScriptCompiler(List<Token> tokens) => _tokens = tokens;

    private Token Next => _tokens[_at];

    /// <exception cref="FormulaException">The text is not a program.</exception>
    public static ScriptCode Compile(string text)
    {
        var compiler = new ScriptCompiler(Lexer.Read(text));
        compiler.Declare();
        compiler.Statements(end: null);
        compiler._code.Add(new Instruction(ScriptOp.Stop, compiler.Next));
        return new ScriptCode
        {
            Instructions = compiler._code.ToArray(),
            GlobalCount = compiler._scope.GlobalCount,
            ArrayCount = compiler._scope.ArrayCount,
            Parameters = compiler._parameters,
            Profiles = compiler._profiles,
            Letters = compiler._procedures.Values.Where(p => p.Name.Length == 1).ToDictionary(p => p.Name[0]),
            StepSlot = compiler._scope.GlobalSlot("step_length"),
            AngleSlot = compiler._scope.GlobalSlot("turn_angle"),
        };
    }

    // Names of procedures, globals and arrays are known everywhere, even before their line.
    private void Declare()
    {
        var depth = 0;
        var procedure = -1;
        for (var i = 0; i + 1 < _tokens.Count; i++)
        {
            var token = _tokens[i];
            var next = _tokens[i + 1];
            if (token.Is("[")) depth++;
            else if (token.Is("]") && --depth == procedure) procedure = -1;
            if (token.IsWord("def") && procedure < 0)
            {
                if (next.Kind == TokenKind.Name) DeclareProcedure(i + 1);
                procedure = depth;
            }
            else if (token.IsWord("array") && next.Kind == TokenKind.Name)
            {
                NewName(next, "array");
                _scope.DeclareArray(next.Text);
            }
            else if (procedure < 0 && token.Kind == TokenKind.Name && next.Is("="))
            {
                NewName(token, "variable");
                _scope.DeclareGlobal(token.Text);
            }
        }
    }

    private void DeclareProcedure(int at)
    {
        var name = _tokens[at];
        NewName(name, "procedure");
        if (TurtleCommands.Find(name.Text) is not null) throw Error("turtle.name",
            $"'{name.Text}' is already a command; choose another name for the procedure.",
            name);
        if (_procedures.ContainsKey(name.Text)) throw Error("turtle.name", $"The procedure '{name.Text}' is defined twice.", name);
        var parameters = new List<string>();
        for (var i = at + 1; _tokens[i].Kind == TokenKind.Name || _tokens[i].Is(","); i++)
        {
            if (_tokens[i].Kind != TokenKind.Name) continue;
            NewName(_tokens[i], "parameter");
            if (parameters.Contains(_tokens[i].Text)) throw Error("turtle.name", $"The parameter '{_tokens[i].Text}' is declared twice.", _tokens[i]);
            parameters.Add(_tokens[i].Text);
        }
        _procedures.Add(name.Text, new Procedure(name.Text, parameters, name));
    }

    private static void NewName(Token name, string kind)
    {
        if (Keywords.Contains(name.Text)
            || ScriptScope.IsState(name.Text)) throw Error("turtle.name", $"'{name.Text}' is a reserved name; choose another name for the {kind}.", name);
    }

    private void Statements(Token? end)
    {
        if (++_nesting > MaxNesting) throw Error("turtle.nesting", "Blocks are nested too deeply.", Next);
        while (true)
        {
            while (Next.Kind == TokenKind.NewLine || Next.Is(";")) _at++;
            if (Next.Kind == TokenKind.End)
            {
                if (end is { } open) throw Error("turtle.bracket", "'[' is never closed by ']'.", open);
                break;
            }
            if (Next.Is("]"))
            {
                if (end is null) throw Error("turtle.bracket", "']' has no matching '['.", Next);
                _at++;
                break;
            }
            Statement();
        }
        _nesting--;
    }

    private void Block()
    {
        SkipLines();
        var open = Next;
        if (!open.Is("[")) throw Error("turtle.syntax", $"Found {open}, expected '['.", open);
        _at++;
        Statements(open);
    }

    private void Statement()
    {
        var token = Next;
        if (token.Kind != TokenKind.Name) throw Error("turtle.syntax", $"Found {token}, expected a command.", token);
        _at++;
        switch (token.Text)
        {
            case "repeat": Repeat(token); return;
            case "for": For(token); return;
            case "if": If(token); return;
            case "while": While(token); return;
            case "break": Break(token); return;
            case "def": Define(token); return;
            case "let": Let(token); return;
            case "param": Param(token); return;
            case "array": NewArray(token); return;
            case "seed": Emit(new Instruction(ScriptOp.Seed, token) { Arguments = [Value("seed", "a number")] }); return;
            case "return": Emit(new Instruction(_scope.InProcedure ? ScriptOp.Return : ScriptOp.Stop, token)); return;
            case "stop": Emit(new Instruction(ScriptOp.Stop, token)); return;
            case "lsystem": Grow(token); return;
            case "use": Use(token); return;
        }
        if (Next.Kind == TokenKind.Symbol && Next.Text is "=" or "+=" or "-=" or "*=" or "/=") Assign(token, declare: false);
        else if (Next.Is("[") && !Next.SpaceBefore && _scope.IsArray(token.Text)) SetElement(token);
        else if (_procedures.TryGetValue(token.Text, out var procedure)) Call(token, procedure);
        else if (TurtleCommands.Find(token.Text) is { } info) Command(token, info);
        else throw Unknown(token);
    }

    private FormulaException Unknown(Token token)
    {
        if (_scope.Variable(token.Text, token) is not null) return Error("turtle.syntax",
            $"'{token.Text}' is a variable; expected a command or '{token.Text} = …'.", token);
        var names = _procedures.Keys.Concat(TurtleCommands.Names)
            .Concat(Keywords.Where(k => k is not ("to" or "step" or "else" or "keep" or "and" or "or" or "not")));
        return Error("turtle.unknown", $"There is no command '{token.Text}'.{SpellingSuggestion.Hint(token.Text, names)}", token);
    }

    private void Call(Token token, Procedure procedure)
    {
        var arguments = Values(procedure.Parameters.Count, procedure.Parameters.Count, false, token,
            $"'{string.Join(" ", new[] { procedure.Name }.Concat(procedure.Parameters))}'");
        Emit(new Instruction(ScriptOp.Call, token) { Procedure = procedure, Arguments = arguments });
    }

    private void Command(Token token, TurtleCommandInfo info)
    {
        TextTemplate? text = null;
        if (info.Text is not null && Next.Kind == TokenKind.Text) text = Template(_tokens[_at++]);
        else if (info.Text is not null && !info.Text.StartsWith("[", StringComparison.Ordinal))
            throw Error("turtle.values", $"'{token.Text}' needs a text: {info.Usage}.", EndsStatement(Next) ? token : Next);
        var arguments = Values(text is null ? info.Required : 0, info.Values.Count, info.MayKeep, token, $"'{info.Usage}'");
        Emit(new Instruction(ScriptOp.Command, token) { Action = info.Action, Arguments = arguments, Text = text, Name = token.Text });
    }

    // Values up to the end of the statement or the next command; separated by spaces or commas.
    private Argument?[] Values(int required, int max, bool mayKeep, Token command, string usage)
    {
        var values = new List<Argument?>();
        while (values.Count < max)
        {
            if (Next.Is(",") && values.Count > 0) _at++;
            else if (!BeginsValue(Next)) break;
            if (Next.IsWord("keep"))
            {
                if (!mayKeep || values.Count >= 3) throw Error("turtle.values", "'keep' is only for coordinates of position and jump.", Next);
                values.Add(null);
                _at++;
                continue;
            }
            values.Add(Value(command.Text, usage));
        }
        if (values.Count < required)
        {
            if (Next.Kind == TokenKind.Name && !Next.IsWord("keep") && !BeginsStatement(Next)) Value(command.Text, usage);
            throw Error("turtle.values", $"'{command.Text}' needs {Count(required)}: {usage}.", command);
        }
        if (!EndsStatement(Next) && Next.Kind != TokenKind.Name) throw Error("turtle.values", $"Found {Next}, expected the end of the command: {usage}.", Next);
        return values.ToArray();
    }

    private Argument Value(string command, string usage)
    {
        var at = Next;
        if (EndsStatement(at)) throw Error("turtle.values", $"'{command}' needs a value: {usage}.", at);
        var parser = new FormulaParser(_tokens, _at, _scope);
        var node = parser.ParseArgument();
        _at = parser.At;
        return new Argument(node, at);
    }

    private Argument Formula(string after)
    {
        var at = Next;
        if (EndsStatement(at)) throw Error("turtle.values", $"'{after}' needs a value.", at);
        var parser = new FormulaParser(_tokens, _at, _scope);
        var node = parser.Parse();
        _at = parser.At;
        return new Argument(node, at);
    }

    private bool BeginsValue(Token t) => t.Kind switch
    {
        TokenKind.Number => true,
        TokenKind.Symbol => t.Text is "(" or "-" or "+" or "!",
        TokenKind.Name => t.Text is "keep" or "not" or "pi" or "tau" || _scope.Variable(t.Text, t) is not null || _scope.IsArray(t.Text)
            || (FormulaFunctions.Knows(t.Text) && !BeginsStatement(t)),
        _ => false,
    };

    private bool BeginsStatement(Token t)
        => _procedures.ContainsKey(t.Text) || TurtleCommands.Find(t.Text) is not null || (Keywords.Contains(t.Text) && t.Text is not ("keep" or "not"));

    private static bool EndsStatement(Token t) => t.Kind is TokenKind.End or TokenKind.NewLine || t.Is(";") || t.Is("]");

    private void SkipLines()
    {
        while (Next.Kind == TokenKind.NewLine) _at++;
    }

    private Instruction Emit(Instruction instruction)
    {
        _code.Add(instruction);
        return instruction;
    }

    private static string Count(int n) => n == 1 ? "one value" : $"{Basics.NumberFormatter.Format(n)} values";

    private static FormulaException Error(string code, string message, Token at) => new(code, message, at.Line, at.Column);
}
