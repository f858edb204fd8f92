namespace Caterpillar.Geometry;

/// <summary>
/// Reads the polygons of PLY files (Turk 1994), ASCII and both binary orders, with any further elements and properties. Polygons are split as fans
/// from their first corner.
/// </summary>
internal sealed class PlyReader(MeshSource source, PlyHeader header)
{
    private readonly PlyData _data = new PlyData(source, header.Format, header.DataAt);
    private MeshBuilder? _builder;
    private int[] _ids = [];
    private int[] _polygon = new int[8];

    public static bool Read(MeshSource source, List<NamedMesh> meshes)
    {
        var header = PlyHeader.Read(source);
        if (header is null) return false;
        var reader = new PlyReader(source, header);
        foreach (var element in header.Elements)
        {
            if (!reader.ReadElement(element)) return false;
        }
        if (reader._builder is not { } builder)
            return source.Fail("mesh.empty", "The PLY file has no element \"vertex\".");
        meshes.Add(new NamedMesh(MeshReader.PlainName(source.Name), builder.ToMesh(source.Name, false, source.Diagnostics)));
        return true;
    }

    private bool ReadElement(PlyElement element)
    {
        if (!_data.Fits(element))
        {
            var count = NumberFormatter.Format(element.Count);
            return _data.Error("mesh.truncated", $"The PLY header states {count} of \"{element.Name}\", more than the file holds.");
        }
        if (element.Properties.Count == 0) return true;
        if (element.Name == "vertex") return ReadVertices(element);
        var faces = element.Name == "face" ? Math.Max(element.Find("vertex_indices"), element.Find("vertex_index")) : -1;
        if (faces >= 0) return ReadFaces(element, faces);
        if (element.Name is "face" or "tristrips")
        {
            var message = $"The element \"{element.Name}\" has no readable list of vertices and is ignored.";
            source.Note(Severity.Warning, "mesh.unsupported", message, new SourceLocation(source.Name, element.Line));
        }
        for (long i = 0; i < element.Count; i++)
        {
            Pulse(i);
            if (!SkipProperties(element, 0, element.Properties.Count)) return false;
        }
        return true;
    }

    private bool ReadVertices(PlyElement element)
    {
        if (_builder is not null) return _data.Error("mesh.syntax", "The PLY file has two elements \"vertex\".");
        var (x, y, z) = (element.Find("x"), element.Find("y"), element.Find("z"));
        if (x < 0 || y < 0 || z < 0) return _data.Error("mesh.syntax", "The vertices have no x, y or z.");
        var count = (int)element.Count;
        source.Afford(2L * count);
        _builder = new MeshBuilder(count, Math.Min(2 * (count / 2 + 16), source.Length / 12));
        _ids = new int[count];
        var point = new double[3];
        var target = new int[element.Properties.Count];
        for (var p = 0; p < target.Length; p++) target[p] = p == x ? 0 : p == y ? 1 : p == z ? 2 : -1;
        for (var i = 0; i < count; i++)
        {
            Pulse(i);
            for (var p = 0; p < target.Length; p++)
            {
                if (target[p] < 0 || element.Properties[p].LengthType is not null)
                {
                    if (!SkipProperties(element, p, p + 1)) return false;
                    continue;
                }
                if (!_data.Read(element.Properties[p].Type, out point[target[p]])) return _data.Wrong("the vertices");
            }
            _ids[i] = _builder.AddVertex(point[0], point[1], point[2]);
        }
        return true;
    }

    private bool ReadFaces(PlyElement element, int list)
    {
        if (_builder is null) return _data.Error("mesh.syntax", "The faces come before the vertices.");
        var property = element.Properties[list];
        if (property.LengthType is not { } lengthType) return _data.Error("mesh.syntax", "The vertices of a face must be a list.");
        var shorts = 0;
        for (long i = 0; i < element.Count; i++)
        {
            Pulse(i);
            if (!SkipProperties(element, 0, list)) return false;
            if (!_data.Read(lengthType, out var length)) return _data.Wrong("the faces");
            if (!(length >= 0) || !_data.Fits(length, property.Type)) return _data.Error("mesh.truncated", "The number of vertices of a face is invalid.");
            var corners = (int)length;
            if (corners > _polygon.Length) Array.Resize(ref _polygon, corners * 2);
            for (var k = 0; k < corners; k++)
            {
                if (!_data.Read(property.Type, out var index)) return _data.Wrong("the faces");
                if (!(index >= 0 && index < _ids.Length) || index != Math.Floor(index))
                    return _data.Error("mesh.index", "A face uses a vertex that does not exist.");
                _polygon[k] = _ids[(int)index];
            }
            if (corners < 3) shorts++;
            if (corners > 1000 || (i & 0xFFFF) == 0) source.Afford((long)_builder.TriangleCount + corners);
            for (var k = 2; k < corners; k++) _builder.AddTriangle(_polygon[0], _polygon[k - 1], _polygon[k]);
            if (!SkipProperties(element, list + 1, element.Properties.Count)) return false;
        }
        if (shorts > 0)
            source.Note(Severity.Warning, "mesh.incomplete_faces", "A face with fewer than three vertices is ignored.", count: shorts);
        return true;
    }

    private bool SkipProperties(PlyElement element, int from, int to)
    {
        for (var p = from; p < to; p++)
        {
            var property = element.Properties[p];
            var values = 1.0;
            if (property.LengthType is { } lengthType)
            {
                if (!_data.Read(lengthType, out values)) return _data.Wrong($"\"{element.Name}\"");
                if (!(values >= 0) || !_data.Fits(values, property.Type)) return _data.Error("mesh.truncated", "The length of a list is invalid.");
            }
            if (!_data.Skip(property.Type, (long)values)) return _data.Wrong($"\"{element.Name}\"");
        }
        return true;
    }

    private void Pulse(long row)
    {
        if ((row & 0xFFFF) == 0) source.Pulse(_data.At, source.Length);
    }
}
