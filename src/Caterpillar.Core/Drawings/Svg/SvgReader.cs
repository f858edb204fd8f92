using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using System.Text;
using System.Xml;
using Caterpillar.Basics;
using Caterpillar.Files;
using Caterpillar.Geometry;
using Caterpillar.Toolpaths;

namespace Caterpillar.Drawings;

/// <summary>
/// Paths and basic shapes of SVG, in the order of the file, as curves in mm: transforms of groups, units and viewBox are applied, and the page stands upright
/// with its lower left corner at the origin. Attributes <c>data-width</c>, <c>data-height</c>, <c>data-area</c>, <c>data-speed</c>, <c>data-multiplier</c>,
/// <c>data-z</c>, <c>data-tool</c> and <c>data-layer</c> (mm, mm², mm/s) on shapes or groups give settings; widths, heights and speeds also as percentages.
/// Elements that refer to others (<c>use</c>, <c>symbol</c>) are followed, text is written in letters of single strokes (<see cref="StrokeFont"/>). Hidden
/// elements and definitions are ignored.
/// </summary>
internal sealed partial class SvgReader
{
    private const int MaxDepth = 512;

    private static readonly HashSet<string> Definitions =
        ["defs", "symbol", "clipPath", "mask", "pattern", "marker", "metadata", "style", "title", "desc", "script", "linearGradient", "radialGradient",
            "filter", "font"];

    private static readonly HashSet<string> Shapes = ["path", "line", "polyline", "polygon", "rect", "circle", "ellipse"];

    private readonly CurveSource _source;
    private readonly string _text;
    private readonly int[] _lines;
    private XmlReader _xml;
    private double _pageHeight = double.NaN;

    private SvgReader(CurveSource source, string text, XmlReader xml)
    {
        _source = source;
        _text = text;
        _xml = xml;
        var starts = new List<int> { 0 };
        for (var i = 0; i < text.Length; i++)
        {
            if (text[i] == '\n' || (text[i] == '\r' && (i + 1 == text.Length || text[i + 1] != '\n'))) starts.Add(i + 1);
        }
        _lines = starts.ToArray();
    }

    public static void Read(CurveSource source)
    {
        var bytes = source.Bytes;
        var at = ByteOrderMark.Length(bytes);
        var text = bytes.Length >= 2 && bytes[0] == 0xFF && bytes[1] == 0xFE ? Encoding.Unicode.GetString(bytes, 2, bytes.Length - 2)
            : bytes.Length >= 2 && bytes[0] == 0xFE && bytes[1] == 0xFF ? Encoding.BigEndianUnicode.GetString(bytes, 2, bytes.Length - 2)
            : Encoding.UTF8.GetString(bytes, at, bytes.Length - at);
        using var xml = XmlReader.Create(new StringReader(text), Settings());
        try
        {
            new SvgReader(source, text, xml).ReadAll();
        }
        catch (XmlException e)
        {
            var message = e.Message;
            var end = message.IndexOf(" Line ", StringComparison.Ordinal);
            source.Error("curves.svg", end > 0 ? message.Substring(0, end) : message, source.Place(Math.Max(1, e.LineNumber), Math.Max(1, e.LinePosition)));
        }
        catch (Exception e) when (e is ArgumentException or InvalidOperationException or IndexOutOfRangeException)
        {
            // Damaged text that makes the XML reader throw.
            source.Error("curves.svg", "This is not well-formed XML.", source.Place(1));
        }
    }

    private static XmlReaderSettings Settings() => new() { DtdProcessing = DtdProcessing.Ignore, XmlResolver = null, CheckCharacters = false };

    private sealed record Scope(Affine Map, UserCurveSettings Settings, double Width, double Height);

    private sealed record UserCurveSettings(double?[] Values, double Z, int Tool, int? Layer, string Name);

    private void ReadAll()
    {
        var page = new Scope(Affine.Identity, new UserCurveSettings(new double?[5], 0, 0, null, ""), 0, 0);
        while (_xml.Read())
        {
            if (_xml.NodeType != XmlNodeType.Element) continue;
            if (_xml.LocalName != "svg") _source.Error("curves.svg", "An SVG file must begin with an svg element.", Here());
            else if (!Hides()) ReadContent(page, true);
            return;
        }
    }

    // What an element "use" refers to; false after an error.
    private bool ReadInside(Scope outer)
    {
        while (_xml.Read())
        {
            if (_xml.NodeType == XmlNodeType.Element) return Hides() || ReadContent(outer, false);
        }
        return true;
    }

    // The element where the reader is, with all that it holds; false after an error.
    private bool ReadContent(Scope first, bool isRoot)
    {
        var scopes = new Stack<Scope>();
        if (!Element(first, isRoot, scopes)) return false;
        while (scopes.Count > 0 && _xml.Read())
        {
            if (_xml.NodeType == XmlNodeType.EndElement) scopes.Pop();
            if (_xml.NodeType != XmlNodeType.Element) continue;
            _source.Pulse(LineStart(Line.LineNumber), _text.Length);
            if (scopes.Count > MaxDepth)
            {
                _source.Error("curves.svg", "Elements are nested too deeply.", Here());
                return false;
            }
            if (!Hides() && !Element(scopes.Peek(), false, scopes)) return false;
        }
        return true;
    }

    private bool Hides()
    {
        if (!Hidden()) return false;
        _source.Diagnostics.Add(Severity.Remark, "curves.hidden", "Hidden elements are ignored.", Here());
        SkipContent();
        return true;
    }

    // False after an error.
    private bool Element(Scope outer, bool isRoot, Stack<Scope> scopes)
    {
        var name = _xml.LocalName;
        var isSymbol = name == "symbol" && _viewport is not null;
        if (name == "use") return Use(outer);
        if (name == "text") return Text(outer);
        if (Definitions.Contains(name) && !isSymbol)
        {
            SkipContent();
            return true;
        }
        if (name is not ("svg" or "symbol" or "g" or "a" or "switch") && !Shapes.Contains(name))
        {
            if (name is "image")
            {
                _source.Diagnostics.Add(Severity.Warning, "curves.svg_" + name, $"Elements \"{name}\" are ignored; convert them to paths.", Here());
            }
            else if (_xml.NamespaceURI is "" or "http://www.w3.org/2000/svg")
            {
                _source.Diagnostics.Add(Severity.Remark, "curves.ignored",
                    $"Elements without curves are ignored, the first is \"{(name.Length > 30 ? name.Substring(0, 30) : name)}\".", Here());
            }
            SkipContent();
            return true;
        }
        var empty = _xml.IsEmptyElement;
        if (Enter(outer, name is "svg" or "symbol", isRoot) is not { } scope) return false;
        if (Shapes.Contains(name) && !Shape(name, scope)) return false;
        _viewport = null;
        if (!empty) scopes.Push(scope);
        return true;
    }

    private void SkipContent()
    {
        if (_xml.IsEmptyElement) return;
        var depth = _xml.Depth;
        while (_xml.Read() && !(_xml.NodeType == XmlNodeType.EndElement && _xml.Depth == depth))
        {
        }
    }

    private Scope? Enter(Scope outer, bool isSvg, bool isRoot)
    {
        var map = outer.Map;
        var (width, height) = (outer.Width, outer.Height);
        if (_xml.GetAttribute("transform") is { } transform && !isRoot)
        {
            if (SvgValues.Transform(transform) is not { } own) return Fail<Scope>("transform", "This is not a list of transforms.");
            map = own.Then(map);
        }
        if (isSvg)
        {
            if (View(isRoot, ref width, ref height) is not { } view) return null;
            map = view.Then(isRoot ? ToMm() : map);
        }
        return Settings(outer.Settings) is { } settings ? new Scope(map, settings, width, height) : null;
    }

    private Affine? View(bool isRoot, ref double width, ref double height)
    {
        double[]? box = null;
        if (_xml.GetAttribute("viewBox") is { } text)
        {
            box = SvgValues.Numbers(text);
            if (box is not { Length: 4 } || !(box[2] > 0 && box[3] > 0))
            {
                return FailValue<Affine>("viewBox", "A viewBox needs four numbers, the last two positive.");
            }
        }
        var ownWidth = Extent("width", box is null ? (isRoot ? 0 : width) : box[2], width, isRoot, out var badWidth);
        var ownHeight = Extent("height", box is null ? (isRoot ? 0 : height) : box[3], height, isRoot, out var badHeight);
        if (_viewport is { } used) (ownWidth, ownHeight, badWidth, badHeight) = (used.Width, used.Height, false, false);
        if (badWidth || badHeight) return FailValue<Affine>(badWidth ? "width" : "height", "This is not a length.");
        double x = 0, y = 0;
        if (!isRoot)
        {
            x = SvgValues.Length(_xml.GetAttribute("x"), width) ?? 0;
            y = SvgValues.Length(_xml.GetAttribute("y"), height) ?? 0;
        }
        else
        {
            _pageHeight = ownHeight;
        }
        (width, height) = box is null ? (ownWidth, ownHeight) : (box[2], box[3]);
        return box is null ? Affine.Move(new Vec3(x, y)) : SvgValues.ViewBox(box, x, y, ownWidth, ownHeight, _xml.GetAttribute("preserveAspectRatio"));
    }

    // For the root, a percentage of the unknown window means the size of its viewBox.
    private double Extent(string name, double missing, double whole, bool isRoot, out bool bad)
    {
        bad = false;
        var text = _xml.GetAttribute(name);
        if (text is null || text.Trim() == "auto" || (isRoot && text.Trim().EndsWith("%", StringComparison.Ordinal))) return missing;
        var value = SvgValues.Length(text, whole);
        bad = value is not > 0;
        return value ?? 0;
    }

    // Pixels with Y down to mm with Y up, the page above the X axis.
    private Affine ToMm()
    {
        const double S = 1 / SvgValues.PixelsPerMm;
        if (_pageHeight == 0)
        {
            _source.Diagnostics.Add(Severity.Remark, "curves.svg_page", "The file states no page height: curves lie below the X axis as drawn.", Here());
        }
        return new Affine(new Vec3(S, 0), new Vec3(0, -S), Vec3.UnitZ, new Vec3(0, _pageHeight * S));
    }

    private UserCurveSettings? Settings(UserCurveSettings outer)
    {
        var values = (double?[])outer.Values.Clone();
        string[] names = ["data-area", "data-width", "data-height", "data-speed", "data-multiplier"];
        for (var i = 0; i < names.Length; i++)
        {
            if (_xml.GetAttribute(names[i]) is not { } text) continue;
            if (Value(text, CurveColumns.Whole(CurveColumn.Area + i, _source.Options)) is not (>= 0 and var value))
            {
                return Fail<UserCurveSettings>(names[i], "Settings of a strand must be numbers of 0 or more, or percentages of something known.");
            }
            values[i] = value;
        }
        var (z, tool, layer) = (outer.Z, outer.Tool, outer.Layer);
        if (_xml.GetAttribute("data-z") is { } height)
        {
            if (Value(height, 0) is not { } value) return Fail<UserCurveSettings>("data-z", "A height must be a number in mm.");
            z = value;
        }
        if (_xml.GetAttribute("data-tool") is { } toolText)
        {
            if (!NumberReader.TryParseInt(toolText.Trim(), out tool)
                || tool is < 0 or > 1000)
            {
                return Fail<UserCurveSettings>("data-tool", "A tool must be a number from 0 to 1000.");
            }
        }
        if (_xml.GetAttribute("data-layer") is { } layerText)
        {
            if (!NumberReader.TryParseInt(layerText.Trim(), out var number)) return Fail<UserCurveSettings>("data-layer", "A layer must be a whole number.");
            layer = number;
        }
        return new UserCurveSettings(values, z, tool, layer, _xml.GetAttribute("data-name") ?? _xml.GetAttribute("id") ?? "");
    }

    private static double? Value(string text, double reference)
    {
        text = text.Trim();
        if (!text.EndsWith("%", StringComparison.Ordinal)) return NumberReader.TryParse(text, out var plain) && Math.Abs(plain) <= 1e9 ? plain : null;
        return reference > 0 && NumberReader.TryParse(text.Substring(0, text.Length - 1).Trim(), out var percent) ? percent / 100 * reference : null;
    }

    private bool Shape(string name, Scope scope)
    {
        var place = Here();
        var diagonal = Math.Sqrt((scope.Width * scope.Width + scope.Height * scope.Height) / 2);
        double? Length(string attribute)
        {
            var text = _xml.GetAttribute(attribute);
            var whole = attribute is "r" ? diagonal : attribute[0] is 'y' || attribute is "cy" or "ry" or "height" ? scope.Height : scope.Width;
            return text is null || text.Trim() == "auto" ? 0 : SvgValues.Length(text, whole);
        }
        var empty = 0;
        IReadOnlyList<Curve>? curves;
        switch (name)
        {
            case "path":
                var data = _xml.GetAttribute("d") ?? "";
                var (subpaths, without, error, at) = SvgPath.Parse(data);
                if (error is not null)
                {
                    _source.Error("curves.svg_path", error, InAttribute("d", at));
                    return false;
                }
                (curves, empty) = (subpaths, without);
                break;
            case "line":
                curves = SvgShapes.Line(Length);
                break;
            case "polyline" or "polygon":
                curves = SvgShapes.Polyline(_xml.GetAttribute("points") ?? "", name == "polygon");
                break;
            case "circle":
                curves = SvgShapes.Ellipse(Length("cx"), Length("cy"), Length("r"), Length("r"));
                break;
            case "ellipse":
                curves = SvgShapes.Ellipse(Length("cx"), Length("cy"), Length("rx"), Length("ry"));
                break;
            default:
                curves = SvgShapes.Rectangle(Length, _xml.GetAttribute("rx") is { } rx && rx != "auto", _xml.GetAttribute("ry") is { } ry && ry != "auto");
                break;
        }
        if (curves is null)
        {
            _source.Error("curves.svg", $"An attribute of this element \"{name}\" is wrong.", place);
            return false;
        }
        if (curves.Count == 0 || empty > 0) _source.TooShort(place);
        foreach (var curve in curves) Add(curve, scope, place);
        return true;
    }

    private void Add(Curve curve, Scope scope, SourceLocation place)
    {
        Curve placed;
        try
        {
            placed = curve.Transformed(scope.Map.Then(Affine.Move(new Vec3(0, 0, scope.Settings.Z))));
        }
        catch (ArgumentException)
        {
            // A map that flattens the curve to a point, or beyond the range of numbers.
            _source.TooShort(place);
            return;
        }
        if (!placed.Bounds.Min.IsFinite || !placed.Bounds.Max.IsFinite)
        {
            _source.Error("curves.not_finite", "Coordinates must be finite.", place);
            return;
        }
        var s = scope.Settings;
        _source.Curves.Add(new UserCurve(placed)
        {
            Name = s.Name,
            Area = s.Values[0],
            Width = s.Values[1],
            Height = s.Values[2],
            Speed = s.Values[3],
            Multiplier = s.Values[4],
            Tool = s.Tool,
            Layer = s.Layer is { } layer ? new Layer(layer, placed.Bounds.Max.Z) : null,
            Source = place,
        });
    }

    private bool Hidden()
    {
        if (_xml.GetAttribute("display") == "none" || _xml.GetAttribute("visibility") == "hidden") return true;
        var style = _xml.GetAttribute("style");
        if (style is null) return false;
        var plain = string.Concat(style.Where(c => c > ' '));
        return plain.IndexOf("display:none", StringComparison.Ordinal) >= 0 || plain.IndexOf("visibility:hidden", StringComparison.Ordinal) >= 0;
    }
}
