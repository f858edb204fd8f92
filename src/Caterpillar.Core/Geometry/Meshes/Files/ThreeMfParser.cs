using System.Xml;

namespace Caterpillar.Geometry;

/// <summary>Reads the XML of one model part of a 3MF package (3MF Core Specification 1.3; paths of the Production Extension).</summary>
internal sealed class ThreeMfParser(MeshSource source, string part, XmlReader xml)
{
    private readonly ThreeMfModel _model = new();
    private bool _good = true;

    /// <summary>How XML of a package is read: without other documents, and not without end.</summary>
    public static XmlReaderSettings Settings(long length) => new()
    {
        DtdProcessing = DtdProcessing.Prohibit,
        XmlResolver = null,
        IgnoreComments = true,
        IgnoreWhitespace = true,
        MaxCharactersInDocument = length,
    };

    /// <summary>The model; null with an error where it cannot be read. May throw what the XML reader throws.</summary>
    public static ThreeMfModel? Parse(MeshSource source, string part, Stream stream)
    {
        using var xml = XmlReader.Create(stream, Settings(Math.Min(int.MaxValue - 1024, GzipReader.Limit(source.Length))));
        var parser = new ThreeMfParser(source, part, xml);
        parser.ReadModel();
        return parser._good ? parser._model : null;
    }

    private void ReadModel()
    {
        for (long nodes = 0; _good && xml.Read(); nodes++)
        {
            if ((nodes & 0xFFF) == 0) source.Pulse(0, 0);
            if (xml.NodeType != XmlNodeType.Element) continue;
            switch (xml.LocalName)
            {
                case "model":
                    ReadUnit();
                    break;
                case "object":
                    ReadObject();
                    break;
                case "item":
                    if (xml.GetAttribute("printable") == "0")
                    {
                        source.Note(Severity.Note, "mesh.ignored", "An item marked as not printable is ignored.", Place());
                        break;
                    }
                    if (ReadUse() is { } item) _model.Items.Add(item);
                    break;
            }
        }
    }

    private void ReadUnit()
    {
        var unit = xml.GetAttribute("unit") ?? "millimeter";
        _model.Unit = unit switch
        {
            "micron" => 0.001,
            "millimeter" => 1,
            "centimeter" => 10,
            "inch" => Units.MmPerInch,
            "foot" => 304.8,
            "meter" => 1000,
            _ => 0,
        };
        if (_model.Unit == 0) Fail("mesh.unit", $"\"{unit}\" is not a unit of 3MF.");
        foreach (var prefix in (xml.GetAttribute("requiredextensions") ?? "").Split([' '], StringSplitOptions.RemoveEmptyEntries))
        {
            var uri = xml.LookupNamespace(prefix) ?? "";
            if (uri.IndexOf("/production/", StringComparison.Ordinal) >= 0 || uri.IndexOf("/material/", StringComparison.Ordinal) >= 0) continue;
            source.Note(Severity.Warning, "mesh.unsupported", $"The model requires the extension \"{prefix}\", which is not supported.", Place());
        }
    }

    private void ReadObject()
    {
        if (!TryInt("id", out var id)) return;
        var named = xml.GetAttribute("name");
        var item = new ThreeMfObject(string.IsNullOrEmpty(named) ? "object " + NumberFormatter.Format(id) : named!, xml.GetAttribute("type") ?? "model");
        if (_model.Objects.ContainsKey(id))
        {
            Fail("mesh.syntax", $"Two objects have the ID {NumberFormatter.Format(id)}.");
            return;
        }
        _model.Objects.Add(id, item);
        if (xml.IsEmptyElement) return;
        var depth = xml.Depth;
        while (_good && xml.Read() && xml.Depth > depth)
        {
            if (xml.NodeType != XmlNodeType.Element) continue;
            if (xml.LocalName == "mesh") ReadMesh(item);
            else if (xml.LocalName == "component" && ReadUse() is { } use) item.Components.Add(use);
        }
    }

    private void ReadMesh(ThreeMfObject item)
    {
        var builder = new MeshBuilder(1024, 2048);
        var ids = new int[1024];
        var vertices = 0;
        var triangles = 0;
        var painted = new List<(int Triangle, bool IsSeam, string Digits)>();
        var depth = xml.Depth;
        if (xml.IsEmptyElement) return;
        for (long nodes = 0; _good && xml.Read() && xml.Depth > depth; nodes++)
        {
            if ((nodes & 0xFFFF) == 0) source.Pulse(0, 0);
            if (xml.NodeType != XmlNodeType.Element) continue;
            if (xml.LocalName == "vertex")
            {
                if (!TryNumber("x", out var x) || !TryNumber("y", out var y) || !TryNumber("z", out var z)) return;
                if (vertices == ids.Length) Array.Resize(ref ids, 2 * vertices);
                ids[vertices++] = builder.AddVertex(x, y, z);
            }
            else if (xml.LocalName == "triangle")
            {
                if (!TryInt("v1", out var a) || !TryInt("v2", out var b) || !TryInt("v3", out var c)) return;
                if ((uint)a >= (uint)vertices || (uint)b >= (uint)vertices || (uint)c >= (uint)vertices)
                {
                    Fail("mesh.index", "A triangle uses a vertex that does not exist.");
                    return;
                }
                var before = builder.TriangleCount;
                builder.AddTriangle(ids[a], ids[b], ids[c]);
                if (builder.TriangleCount == before) item.Dropped.Add(triangles);
                else if (xml.AttributeCount > 3) ReadPaint(before, painted);
                triangles++;
            }
        }
        if (builder.NotFinite > 0)
            source.Note(Severity.Warning, "mesh.not_finite", "A triangle with a coordinate beyond 1e9 is ignored.", Place(), builder.NotFinite);
        if (builder.Degenerate > 0)
            source.Note(Severity.Note, "mesh.degenerate_faces", "A triangle with two equal vertices is ignored.", Place(), builder.Degenerate);
        var mesh = item.Mesh = builder.ToMesh();
        foreach (var (triangle, isSeam, digits) in painted)
        {
            var (a, b, c) = mesh.Triangle(triangle);
            ThreeMfPaint.Read(digits, isSeam, mesh.RawVertices[a], mesh.RawVertices[b], mesh.RawVertices[c], item.Paint);
        }
    }

    private void ReadPaint(int triangle, List<(int Triangle, bool IsSeam, string Digits)> painted)
    {
        if ((xml.GetAttribute("slic3rpe:custom_supports") ?? xml.GetAttribute("paint_supports")) is { } supports) painted.Add((triangle, false, supports));
        if ((xml.GetAttribute("slic3rpe:custom_seam") ?? xml.GetAttribute("paint_seam")) is { } seam) painted.Add((triangle, true, seam));
        if ((xml.GetAttribute("slic3rpe:mmu_segmentation") ?? xml.GetAttribute("paint_color")) is { Length: > 0 })
            source.Note(Severity.Warning, "mesh.painted_tools", "Faces painted for other tools are printed with the tool of their part.", Place());
    }

    private ThreeMfUse? ReadUse()
    {
        if (!TryInt("objectid", out var id)) return null;
        var place = xml as IXmlLineInfo;
        string? path = null;
        for (var i = 0; i < xml.AttributeCount; i++)
        {
            xml.MoveToAttribute(i);
            if (xml.LocalName == "path") path = xml.Value;
        }
        xml.MoveToElement();
        if (!TryMap(xml.GetAttribute("transform"), out var map))
        {
            Fail("mesh.syntax", "A transform must have twelve numbers and must not be singular.");
            return null;
        }
        return new ThreeMfUse(path, id, map, place?.LineNumber ?? 0, place?.LinePosition ?? 0);
    }

    // Row vectors: p' = p · M, the last of the four rows is the shift.
    private static bool TryMap(string? text, out Affine map)
    {
        map = Affine.Identity;
        if (text is null) return true;
        var words = text.Split([' ', '\t', '\n', '\r'], StringSplitOptions.RemoveEmptyEntries);
        if (words.Length != 12) return false;
        var m = new double[12];
        for (var i = 0; i < 12; i++)
        {
            if (!NumberReader.TryParse(words[i], out m[i])) return false;
        }
        map = new Affine(new Vec3(m[0], m[1], m[2]), new Vec3(m[3], m[4], m[5]), new Vec3(m[6], m[7], m[8]), new Vec3(m[9], m[10], m[11]));
        return Math.Abs(map.Determinant) is > 0 and < double.PositiveInfinity;
    }

    private bool TryInt(string attribute, out int value)
        => (NumberReader.TryParseInt(xml.GetAttribute(attribute), out value) && value >= 0)
            || Fail("mesh.syntax", $"<{xml.LocalName}> needs an integer \"{attribute}\".");

    private bool TryNumber(string attribute, out double value)
        => NumberReader.TryParse(xml.GetAttribute(attribute), out value) || Fail("mesh.syntax", $"<{xml.LocalName}> needs a number \"{attribute}\".");

    private SourceLocation Place() => xml is IXmlLineInfo info
        ? new SourceLocation(source.Name, info.LineNumber, info.LinePosition, part)
        : new SourceLocation(source.Name, Key: part);

    private bool Fail(string code, string message)
    {
        _good = false;
        return source.Fail(code, message, Place());
    }
}
