using System.Collections.Generic;
using Caterpillar.Expressions;

namespace Caterpillar.Turtles;

// Other files, values that procedures return, and printed lines.
internal sealed partial class ScriptCompiler
{
    // include "file": its statements run here, the first time that a file is included.
    private void Include(Token token)
    {
        const string Usage = "include \"file\"";
        if (Next.Kind != TokenKind.Text) throw Error("turtle.values", $"'include' needs the name of a file: {Usage}.", token);
        NotInBlock(token);
        var name = _at++;
        if (!EndsStatement(Next)) throw Error("turtle.values", $"Found {Next}, expected the end of the command: {Usage}.", Next);
        if (!_source.Includes.TryGetValue(name, out var source) || source is null) return;
        var outermost = _outermost;
        _outermost = _nesting + 1;
        Within(source, () => Statements(end: null));
        _outermost = outermost;
    }

    // image name "file" [smooth]: a function of two numbers, which Declare has declared.
    private void Image(Token token)
    {
        const string Usage = "image name \"file\" [smooth]";
        NotInBlock(token);
        if (Next.Kind != TokenKind.Name || !_source.Images.ContainsKey(_at + 1))
            throw Error("turtle.values", $"'image' needs a name and the name of a file: {Usage}.", token);
        _at += 2;
        if (IsSmooth(_at)) _at++;
        if (!EndsStatement(Next)) throw Error("turtle.values", $"Found {Next}, expected the end of the command: {Usage}.", Next);
    }

    private void Return(Token token)
    {
        var hasValue = IsValueAfterReturn(_at);
        if (hasValue && !_scope.InProcedure) throw Error("turtle.syntax", "'return' with a value is only for procedures.", token);
        Argument[] value = hasValue ? [Formula("return")] : [];
        if (hasValue && !EndsStatement(Next)) throw Error("turtle.values", $"Found {Next}, expected the end of the value.", Next);
        CloseShapings(0, token);
        Emit(new Instruction(_scope.InProcedure ? ScriptOp.Return : ScriptOp.Stop, token) { Arguments = value });
    }

    // print "text" value …: texts and values, separated by spaces.
    private void Print(Token token)
    {
        var texts = new List<string> { "" };
        var values = new List<Argument>();
        var first = true;
        while (!EndsStatement(Next))
        {
            if (Next.Is(",") && !first) _at++;
            if (Next.Kind != TokenKind.Text && !BeginsValue(Next)) break;
            if (!first) texts[texts.Count - 1] += " ";
            first = false;
            if (Next.Kind != TokenKind.Text)
            {
                values.Add(Value("print", "print \"text\" value …"));
                texts.Add("");
                continue;
            }
            var template = Template(_tokens[_at++]);
            texts[texts.Count - 1] += template.Texts[0];
            values.AddRange(template.Values);
            for (var i = 1; i < template.Texts.Count; i++) texts.Add(template.Texts[i]);
        }
        if (!EndsStatement(Next) && Next.Kind != TokenKind.Name)
        {
            throw Error("turtle.values", $"Found {Next}, expected a text, a value or the end of the line.", Next);
        }
        if (first && !EndsStatement(Next) && !BeginsStatement(Next)) Value("print", "print \"text\" value …");
        Emit(new Instruction(ScriptOp.Print, token) { Text = new TextTemplate(texts, values) });
    }

    private void NotInBlock(Token token)
    {
        if (_nesting > _outermost || _scope.InProcedure) throw Error("turtle.syntax", $"'{token.Text}' must not be inside a block.", token);
    }
}
