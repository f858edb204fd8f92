using System;
using System.Collections.Generic;
using System.Globalization;
using System.Linq;
using System.Text;
using System.Xml;
using System.Xml.Linq;
using Caterpillar.Basics;
using Caterpillar.Geometry;

namespace Caterpillar.Drawings;

// Elements that refer to others, and text, which is written in letters of single strokes.
internal sealed partial class SvgReader
{
    private const int MaxUses = 100_000;
    private const int MaxUseDepth = 32;
    private const double BytesPerCurve = 400;

    // Capitals of common fonts, in sizes of the font.
    private const double CapHeight = 0.7;
    private const double UsualSize = 16;

    private Dictionary<string, XElement>? _named;
    private (double Width, double Height)? _viewport;
    private int _uses;
    private int _useDepth;

    // False after an error.
    private bool Use(Scope outer)
    {
        if (Enter(outer, false, false) is not { } scope) return false;
        var place = Here();
        var href = (_xml.GetAttribute("href") ?? _xml.GetAttribute("href", "http://www.w3.org/1999/xlink") ?? "").Trim();
        double Length(string name, double whole, double missing) => SvgValues.Length(_xml.GetAttribute(name), whole) ?? missing;
        var move = Affine.Move(new Vec3(Length("x", scope.Width, 0), Length("y", scope.Height, 0)));
        var viewport = (Length("width", scope.Width, scope.Width), Length("height", scope.Height, scope.Height));
        SkipContent();
        if (href.Length < 2 || href[0] != '#' || !Named().TryGetValue(href.Substring(1), out var target))
        {
            _source.Diagnostics.Add(Severity.Warning, "curves.svg_use", "What an element \"use\" refers to is not in the file; it is ignored.", place);
            return true;
        }
        if (++_uses > MaxUses || _useDepth == MaxUseDepth)
        {
            _source.Error("curves.svg", "Elements \"use\" refer to each other, or there are too many.", place);
            return false;
        }
        if (_source.Options.Memory.Refuse(_source.Curves.Count * BytesPerCurve, "What elements \"use\" repeat", place) is { } tooMuch)
        {
            _source.Diagnostics.Add(tooMuch);
            return false;
        }
        var kept = _xml;
        _useDepth++;
        _xml = target.CreateReader();
        _viewport = viewport;
        var good = ReadInside(scope with { Map = move.Then(scope.Map) });
        _viewport = null;
        _xml = kept;
        _useDepth--;
        return good;
    }

    // The first of equal names counts.
    private Dictionary<string, XElement> Named()
    {
        if (_named is not null) return _named;
        _named = new Dictionary<string, XElement>(StringComparer.Ordinal);
        using var xml = XmlReader.Create(new System.IO.StringReader(_text), Settings());
        foreach (var element in XDocument.Load(xml, LoadOptions.SetLineInfo).Descendants())
        {
            if (element.Attribute("id") is { } id && !_named.ContainsKey(id.Value)) _named.Add(id.Value, element);
        }
        return _named;
    }

    // False after an error.
    private bool Text(Scope outer)
    {
        if (Enter(outer, false, false) is not { } scope) return false;
        var place = Here();
        var cap = FontSize() * CapHeight;
        var anchor = _xml.GetAttribute("text-anchor") ?? Style("text-anchor") ?? "start";
        var (x, y) = (0.0, 0.0);
        Place(scope, ref x, ref y);
        if (_xml.IsEmptyElement) return true;
        var depth = _xml.Depth;
        while (_xml.Read() && !(_xml.NodeType == XmlNodeType.EndElement && _xml.Depth == depth))
        {
            if (_xml.NodeType == XmlNodeType.Element) Place(scope, ref x, ref y);
            if (_xml.NodeType is not (XmlNodeType.Text or XmlNodeType.CDATA) || !(cap > 0)) continue;
            var line = OneLine(_xml.Value);
            if (line.Any(c => !StrokeFont.Has(c)))
                _source.Diagnostics.Add(Severity.Warning, "curves.svg_letters", "Characters that the font of single strokes lacks are drawn as boxes.", place);
            var width = StrokeFont.Advance(line, cap);
            var start = anchor == "middle" ? x - width / 2 : anchor == "end" ? x - width : x;
            foreach (var stroke in StrokeFont.Strokes(line, cap))
                Add(new PolylineCurve(Array.ConvertAll(stroke, p => new Vec3(start + p.X, y - p.Y)), false), scope, place);
            x += width;
        }
        return true;
    }

    // Where an element of text begins; what it does not say goes on from before.
    private void Place(Scope scope, ref double x, ref double y)
    {
        double? First(string name, double whole) => _xml.GetAttribute(name) is { } list
            ? SvgValues.Length(list.Trim().Split(' ', ',')[0], whole) : null;
        x = (First("x", scope.Width) ?? x) + (First("dx", scope.Width) ?? 0);
        y = (First("y", scope.Height) ?? y) + (First("dy", scope.Height) ?? 0);
    }

    private double FontSize()
    {
        var text = _xml.GetAttribute("font-size") ?? Style("font-size");
        return SvgValues.Length(text, UsualSize) is { } size && size <= 1e6 ? size : UsualSize;
    }

    private string? Style(string name)
    {
        foreach (var part in (_xml.GetAttribute("style") ?? "").Split(';'))
        {
            var colon = part.IndexOf(':', 0);
            if (colon > 0 && part.Substring(0, colon).Trim() == name) return part.Substring(colon + 1).Trim();
        }
        return null;
    }

    // Runs of spaces and line ends are one space, as in browsers; letters of two are written as two.
    private static string OneLine(string text)
    {
        var line = new StringBuilder(text.Length);
        foreach (var c in text)
        {
            if (c is ' ' or '\t' or '\n' or '\r')
            {
                if (line.Length > 0 && line[line.Length - 1] != ' ') line.Append(' ');
            }
            else
            {
                line.Append(c switch { '\u00E6' => "ae", '\u00C6' => "AE", '\u0153' => "oe", '\u0152' => "OE", _ => c.ToString(CultureInfo.InvariantCulture) });
            }
        }
        return line.ToString().TrimEnd(' ');
    }
}
