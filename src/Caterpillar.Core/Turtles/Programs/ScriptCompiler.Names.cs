using System.Collections.Generic;
using System.Linq;
using Caterpillar.Expressions;

namespace Caterpillar.Turtles;

// Names of procedures, globals, arrays and images are known everywhere, even before their line.
internal sealed partial class ScriptCompiler
{
    private static readonly string[] ShapingWords = ["deform", "modulate", "gap_bead", "cool_layers"];

    private void Declare()
    {
        Declare(_source);
        DeclareValues(_source);
    }

    private void Declare(ScriptSource source)
    {
        Within(source, () =>
        {
            var depth = 0;
            var procedure = -1;
            for (var i = 0; i + 1 < _tokens.Count; i++)
            {
                var token = _tokens[i];
                var next = _tokens[i + 1];
                if (token.Is("[")) depth++;
                else if (token.Is("]") && --depth == procedure) procedure = -1;
                if (source.Includes.TryGetValue(i, out var included) && included is not null) Declare(included);
                if (ShapingWords.Contains(token.Text) && token.Kind == TokenKind.Name)
                {
                    // The names of its values are no variables of the script.
                    while (i + 2 < _tokens.Count && !_tokens[i + 1].Is("[")) i++;
                }
                else if (token.IsWord("def") && procedure < 0)
                {
                    if (next.Kind == TokenKind.Name) DeclareProcedure(i + 1);
                    procedure = depth;
                }
                else if (token.IsWord("array") && next.Kind == TokenKind.Name)
                {
                    NewName(next, "array");
                    _scope.DeclareArray(next.Text);
                }
                else if (token.IsWord("image") && next.Kind == TokenKind.Name && source.Images.TryGetValue(i + 2, out var image))
                {
                    NewName(next, "image");
                    if (!_scope.DeclareImage(next.Text, image, IsSmooth(i + 3)))
                        throw Error("turtle.name", $"The image '{next.Text}' is declared twice.", next);
                }
                else if (procedure < 0 && token.Kind == TokenKind.Name && next.Is("="))
                {
                    NewName(token, "variable");
                    _scope.DeclareGlobal(token.Text);
                }
            }
        });
    }

    private void DeclareProcedure(int at)
    {
        var name = _tokens[at];
        NewName(name, "procedure");
        if (TurtleCommands.Find(name.Text) is not null)
        {
            throw Error("turtle.name", $"'{name.Text}' is already a command; choose another name for the procedure.", name);
        }
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

    // Which procedures return a value: only when all names are known, a name after 'return' can be told from the next command.
    private void DeclareValues(ScriptSource source)
    {
        Within(source, () =>
        {
            Procedure? procedure = null;
            for (var i = 0; i + 1 < _tokens.Count; i++)
            {
                if (source.Includes.TryGetValue(i, out var included) && included is not null) DeclareValues(included);
                if (_tokens[i].IsWord("def")) _procedures.TryGetValue(_tokens[i + 1].Text, out procedure);
                else if (procedure is not null && _tokens[i].IsWord("return") && IsValueAfterReturn(i + 1)) procedure.ReturnsValue = true;
            }
        });
    }

    private bool IsValueAfterReturn(int at)
    {
        var token = _tokens[at];
        return token.Kind switch
        {
            TokenKind.Number => true,
            TokenKind.Symbol => token.Text is "(" or "-" or "+" or "!",
            TokenKind.Name => !BeginsStatement(token) || IsBeforeBracket(at),
            _ => false,
        };
    }

    private bool IsSmooth(int at) => at < _tokens.Count && _tokens[at].IsWord("smooth");

    // Works on the tokens of a file, whose name errors carry.
    private void Within(ScriptSource source, System.Action work)
    {
        var (outer, at) = (_source, _at);
        (_source, _tokens, _at) = (source, source.Tokens, 0);
        try
        {
            work();
        }
        catch (FormulaException e) when (e.File is null)
        {
            e.File = source.File;
            throw;
        }
        (_source, _tokens, _at) = (outer, outer.Tokens, at);
    }
}
