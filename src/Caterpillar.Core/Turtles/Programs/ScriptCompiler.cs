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
        "and", "or", "not", "print", "include", "image", "deform", "modulate", "gap_bead", "cool_layers",
    ];

    private readonly List<Instruction> _code = [];
    private readonly Dictionary<string, Procedure> _procedures = new(StringComparer.Ordinal);
    private readonly ScriptScope _scope;
    private readonly List<string> _parameters = [];
    private readonly Stack<Leaving> _breaks = new();
    private readonly List<string> _profiles = [];
    private ScriptSource _source;
    private List<Token> _tokens;
    private int _at;
    private int _nesting;
    private int _outermost = 1;

    private ScriptCompiler(ScriptSource source)
    {
        _scope = new ScriptScope(_procedures);
        _source = source;
        _tokens = source.Tokens;
    }

    private Token Next => _tokens[_at];

    /// <exception cref="FormulaException">The text is not a program.</exception>
    public static ScriptCode Compile(string text, string? file, ScriptFiles files)
    {
        var compiler = new ScriptCompiler(ScriptSource.Read(text, file, files));
        compiler.Declare();
        compiler.Statements(end: null);
        compiler._code.Add(new Instruction(ScriptOp.Stop, compiler.Next));
        return new ScriptCode
        {
            Instructions = compiler._code.ToArray(),
            GlobalCount = compiler._scope.GlobalCount,
            ArrayCount = compiler._scope.ArrayCount,
            CallsFunctions = compiler._scope.CallsFunctions,
            Parameters = compiler._parameters,
            Profiles = compiler._profiles,
            Letters = compiler._procedures.Values.Where(p => p.Name.Length == 1).ToDictionary(p => p.Name[0]),
            StepSlot = compiler._scope.GlobalSlot("step_length"),
            AngleSlot = compiler._scope.GlobalSlot("turn_angle"),
        };
    }

    private static void NewName(Token name, string kind)
    {
        if (Keywords.Contains(name.Text)
            || ScriptScope.IsState(name.Text))
        {
            throw Error("turtle.name", $"'{name.Text}' is a reserved name; choose another name for the {kind}.", name);
        }
    }

    private void Statements(Token? end)
    {
        if (++_nesting > MaxNesting) throw Error("turtle.nesting", $"Blocks are nested more than {Basics.NumberFormatter.Format(MaxNesting)} deep.", Next);
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
            case "return": Return(token); return;
            case "stop": Emit(new Instruction(ScriptOp.Stop, token)); return;
            case "print": Print(token); return;
            case "include": Include(token); return;
            case "image": Image(token); return;
            case "deform" or "modulate" or "gap_bead" or "cool_layers": Shape(token); return;
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
        if (_scope.Variable(token.Text, token) is not null)
        {
            return Error("turtle.syntax", $"'{token.Text}' is a variable; expected a command or '{token.Text} = …'.", token);
        }
        var names = _procedures.Keys.Concat(TurtleCommands.Names)
            .Concat(Keywords.Where(k => k is not ("to" or "step" or "else" or "keep" or "and" or "or" or "not")));
        return Error("turtle.unknown", $"There is no command '{token.Text}'.{SpellingSuggestion.Hint(token.Text, names)}", token);
    }

    private void Call(Token token, Procedure procedure)
    {
        var count = procedure.Parameters.Count;
        var usage = $"'{string.Join(" ", new[] { procedure.Name }.Concat(procedure.Parameters))}'";
        var arguments = IsList() ? List(count, token, usage) : Values(count, count, false, token, usage);
        Emit(new Instruction(ScriptOp.Call, token) { Procedure = procedure, Arguments = arguments });
    }

    // name(1, 2) or name(), as in a formula; name (1 + 2) has one value in brackets.
    private bool IsList()
    {
        if (!Next.Is("(") || Next.SpaceBefore) return false;
        if (_tokens[_at + 1].Is(")")) return true;
        var depth = 0;
        for (var i = _at; i < _tokens.Count && _tokens[i].Kind is not (TokenKind.NewLine or TokenKind.End); i++)
        {
            if (_tokens[i].Is("(")) depth++;
            else if (_tokens[i].Is(")") && --depth == 0) break;
            else if (_tokens[i].Is(",") && depth == 1) return true;
        }
        return false;
    }

    private Argument?[] List(int count, Token name, string usage)
    {
        var open = Next;
        var values = new List<Argument?>();
        do
        {
            _at++;
            if (Next.Is(")") && values.Count == 0) break;
            values.Add(Formula(name.Text));
        }
        while (Next.Is(","));
        if (!Next.Is(")")) throw Error("formula.bracket", $"Found {Next}, expected ')'.", open);
        _at++;
        if (values.Count != count) throw Error("turtle.values", $"'{name.Text}' needs {Count(count)}: {usage}.", name);
        return values.ToArray();
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
            if (Next.Kind == TokenKind.Name && !Next.IsWord("keep") && (!BeginsStatement(Next) || IsBeforeBracket(_at))) Value(command.Text, usage);
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
            || (FormulaFunctions.Knows(t.Text) && !BeginsStatement(t)) || IsCall(t),
        _ => false,
    };

    // A function directly before its '('; with a space it is a statement.
    private bool IsCall(Token t) => _scope.IsFunction(t.Text) && IsBeforeBracket(_at);

    private bool IsBeforeBracket(int at) => _tokens[at + 1].Is("(") && !_tokens[at + 1].SpaceBefore;

    private bool BeginsStatement(Token t)
        => _procedures.ContainsKey(t.Text) || TurtleCommands.Find(t.Text) is not null || (Keywords.Contains(t.Text) && t.Text is not ("keep" or "not"));

    private static bool EndsStatement(Token t) => t.Kind is TokenKind.End or TokenKind.NewLine || t.Is(";") || t.Is("]");

    private void SkipLines()
    {
        while (Next.Kind == TokenKind.NewLine) _at++;
    }

    private Instruction Emit(Instruction instruction)
    {
        instruction.File = _source.File;
        _code.Add(instruction);
        return instruction;
    }

    private static string Count(int n) => n == 1 ? "one value" : $"{Basics.NumberFormatter.Format(n)} values";

    private static FormulaException Error(string code, string message, Token at) => new(code, message, at.Line, at.Column);
}
