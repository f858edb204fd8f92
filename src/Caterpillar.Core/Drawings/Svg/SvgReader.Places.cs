using System;
using System.Xml;
using Caterpillar.Basics;

namespace Caterpillar.Drawings;

// Where in the file something is, for messages.
internal sealed partial class SvgReader
{
    private IXmlLineInfo Line => (IXmlLineInfo)_xml;

    private SourceLocation Here() => _source.Place(Math.Max(1, Line.LineNumber), Math.Max(1, Line.LinePosition));

    private int LineStart(int line) => line >= 1 && line <= _lines.Length ? _lines[line - 1] : 0;

    // The position of a character of an attribute's value in the file.
    private SourceLocation InAttribute(string name, int index)
    {
        if (!_xml.MoveToAttribute(name)) return Here();
        var at = LineStart(Line.LineNumber) + Line.LinePosition - 1;
        _xml.MoveToElement();
        while (at < _text.Length && _text[at] != '"' && _text[at] != '\'') at++;
        at++;
        for (; index > 0 && at < _text.Length; index--)
        {
            if (_text[at] == '&')
            {
                var end = _text.IndexOf(';', at);
                at = end < 0 ? at : end;
            }
            else if (_text[at] == '\r' && at + 1 < _text.Length && _text[at + 1] == '\n')
            {
                at++;
            }
            at++;
        }
        var line = Array.BinarySearch(_lines, Math.Min(at, _text.Length));
        if (line < 0) line = ~line - 1;
        return _source.Place(line + 1, at - _lines[line] + 1);
    }

    private T? Fail<T>(string attribute, string message)
        where T : class
    {
        _source.Error("curves.svg", message, InAttribute(attribute, 0));
        return null;
    }

    private T? FailValue<T>(string attribute, string message)
        where T : struct
    {
        _source.Error("curves.svg", message, InAttribute(attribute, 0));
        return null;
    }
}
