using System.Xml;
using System.Xml.Linq;

namespace Caterpillar.Drawings;

/// <summary>The XML of a drawing at the current element, with its position in the file.</summary>
internal sealed class SvgXml
{
    private readonly CurveSource _source;
    private readonly string _text;
    private readonly int[] _lines;
    private Dictionary<string, XElement>? _named;
    private Dictionary<string, string>? _classes;

    public SvgXml(CurveSource source, string text, XmlReader reader)
    {
        _source = source;
        _text = text;
        Reader = reader;
        var starts = new List<int> { 0 };
        for (var i = 0; i < text.Length; i++)
        {
            if (text[i] == '\n' || (text[i] == '\r' && (i + 1 == text.Length || text[i + 1] != '\n'))) starts.Add(i + 1);
        }
        _lines = starts.ToArray();
    }

    /// <summary>Reader at the current element. While an element is repeated, it is the reader of the repeated element.</summary>
    public XmlReader Reader { get; set; }

    private IXmlLineInfo Line => (IXmlLineInfo)Reader;

    /// <summary>A reader of the text of a drawing.</summary>
    public static XmlReader Open(string text) => XmlReader.Create(
        new StringReader(text), new XmlReaderSettings { DtdProcessing = DtdProcessing.Ignore, XmlResolver = null, CheckCharacters = false });

    public string? Attribute(string name) => Reader.GetAttribute(name);

    public SourceLocation Here() => _source.Place(Math.Max(1, Line.LineNumber), Math.Max(1, Line.LinePosition));

    /// <summary>Reports the progress of reading.</summary>
    public void Pulse() => _source.Pulse(LineStart(Line.LineNumber), _text.Length);

    public void SkipContent()
    {
        if (Reader.IsEmptyElement) return;
        var depth = Reader.Depth;
        while (Reader.Read() && !(Reader.NodeType == XmlNodeType.EndElement && Reader.Depth == depth))
        {
        }
    }

    public bool IsHidden() => Property("display") == "none" || Property("visibility") == "hidden";

    /// <summary>A property of the current element by its attribute "style", its classes in style sheets, or the attribute of this name. Null = none.</summary>
    public string? Property(string name)
    {
        var value = Declared(Attribute("style"), name);
        foreach (var one in (Attribute("class") ?? "").Split(' '))
        {
            if (value is null && Classes().TryGetValue(one, out var declarations)) value = Declared(declarations, name);
        }
        return value ?? Attribute(name);
    }

    /// <summary>Elements by id. If ids are equal, the first counts.</summary>
    public Dictionary<string, XElement> Named()
    {
        if (_named is not null) return _named;
        _named = new Dictionary<string, XElement>(StringComparer.Ordinal);
        using var xml = Open(_text);
        foreach (var element in XDocument.Load(xml, LoadOptions.SetLineInfo).Descendants())
        {
            if (element.Attribute("id") is { } id && !_named.ContainsKey(id.Value)) _named.Add(id.Value, element);
        }
        return _named;
    }

    /// <summary>The position of a character of an attribute's value in the file.</summary>
    public SourceLocation InAttribute(string name, int index)
    {
        if (!Reader.MoveToAttribute(name)) return Here();
        var at = LineStart(Line.LineNumber) + Line.LinePosition - 1;
        Reader.MoveToElement();
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

    /// <summary>An error at an attribute; the default of a type, for what comes of it.</summary>
    public T? Fail<T>(string attribute, string message)
    {
        _source.Fail("curves.svg", message, InAttribute(attribute, 0));
        return default;
    }

    private static string? Declared(string? declarations, string name)
    {
        foreach (var part in (declarations ?? "").Split(';'))
        {
            var colon = part.IndexOf(':', 0);
            if (colon > 0 && part.Substring(0, colon).Trim() == name) return part.Substring(colon + 1).Split('!')[0].Trim();
        }
        return null;
    }

    // What style sheets declare of single classes, the last rules first.
    private Dictionary<string, string> Classes()
    {
        if (_classes is not null) return _classes;
        _classes = new Dictionary<string, string>(StringComparer.Ordinal);
        for (int at = _text.IndexOf("<style", StringComparison.Ordinal), end; at >= 0; at = _text.IndexOf("<style", end, StringComparison.Ordinal))
        {
            end = _text.IndexOf("</style", at, StringComparison.Ordinal);
            if (end < 0) break;
            foreach (var rule in _text.Substring(at, end - at).Split('}'))
            {
                var open = rule.IndexOf('{', 0);
                foreach (var selector in rule.Substring(0, Math.Max(0, open)).Split(','))
                {
                    // The first one comes after the tag, others after comments.
                    var name = selector.Substring(selector.LastIndexOfAny(['>', '[', '/']) + 1).Trim();
                    if (!name.StartsWith(".", StringComparison.Ordinal)) continue;
                    _classes.TryGetValue(name.Substring(1), out var earlier);
                    _classes[name.Substring(1)] = rule.Substring(open + 1) + ";" + earlier;
                }
            }
        }
        return _classes;
    }

    private int LineStart(int line) => line >= 1 && line <= _lines.Length ? _lines[line - 1] : 0;
}
