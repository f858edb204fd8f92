namespace Caterpillar.Geometry;

/// <summary>
/// Reads the polygons of Wavefront OBJ: <c>v</c> and <c>f</c> in all forms, negative indices, indices of vertices that come later, continued lines. Polygons
/// are split as fans from their first vertex. All objects and groups become one mesh, because groups often are patches of one surface. Materials are ignored.
/// </summary>
internal sealed class ObjReader(MeshSource source)
{
    private readonly TextCursor _cursor = new(source.Bytes, ByteOrderMark.Length(source.Bytes), source.Length);
    private readonly MeshBuilder _builder = new(source.Length / 60 + 16, source.Length / 30 + 32);
    private int[] _ids = new int[source.Length / 60 + 16];
    private int _vertices;
    private int[] _corners = new int[source.Length / 10 + 96];
    private int _used;
    private int _largest = -1;
    private int _largestAt;
    private string _name = "";

    public static bool Read(MeshSource source, List<NamedMesh> meshes)
    {
        var reader = new ObjReader(source);
        if (!reader.ReadLines()) return false;
        if (reader._largest >= reader._vertices)
        {
            var (index, count) = (NumberFormatter.Format(reader._largest + 1L), NumberFormatter.Format(reader._vertices));
            return source.ErrorInText("mesh.index", $"A face uses vertex {index}, but the file has only {count}.", reader._largestAt);
        }
        var (ids, corners) = (reader._ids, reader._corners);
        for (var i = 0; i < reader._used; i += 3) reader._builder.AddTriangle(ids[corners[i]], ids[corners[i + 1]], ids[corners[i + 2]]);
        var name = reader._name.Length > 0 ? reader._name : MeshReader.PlainName(source.Name);
        meshes.Add(new NamedMesh(name, reader._builder.ToMesh(source.Name, false, source.Diagnostics)));
        return true;
    }

    private bool ReadLines()
    {
        for (var lines = 0; _cursor.SkipSpace(); lines++)
        {
            if ((lines & 0xFFFF) == 0) source.Pulse(_cursor.At, source.Length);
            var first = _cursor.Bytes[_cursor.At];
            var start = _cursor.SkipWord();
            var length = _cursor.At - start;
            if (length == 1 && first == 'v')
            {
                if (!ReadVertex()) return false;
            }
            else if (length == 1 && first == 'f')
            {
                if (!ReadFace(start)) return false;
            }
            else
            {
                Other(start);
            }
            // What is left of the line, with its continuations.
            while (_cursor.SkipSpaces()) _cursor.SkipWord();
            _cursor.SkipLine();
        }
        return true;
    }

    private bool ReadVertex()
    {
        if (!_cursor.ReadPoint(withinLine: true, out var x, out var y, out var z))
            return _cursor.AtEnd ? source.ErrorInText("mesh.truncated", "The file ends inside a vertex.", _cursor.At)
                : source.ErrorInText("mesh.syntax", "A vertex needs three numbers.", _cursor.At);
        if (_vertices == _ids.Length)
        {
            source.Afford(2L * _vertices);
            Array.Resize(ref _ids, _vertices * 2);
        }
        _ids[_vertices++] = _builder.AddVertex(x, y, z);
        return true;
    }

    private bool ReadFace(int faceAt)
    {
        int first = 0, last = 0, count = 0;
        while (_cursor.SkipSpaces())
        {
            if (_cursor.Bytes[_cursor.At] == '#') break;
            if (!ReadCorner(faceAt, out var corner)) return false;
            if (count == 0) first = corner;
            if (count >= 2) Push(first, last, corner);
            last = corner;
            count++;
        }
        if (count < 3)
            source.Note(Severity.Warning, "mesh.incomplete_faces", "A face with fewer than three vertices is ignored.", source.PlaceInText(faceAt));
        return true;
    }

    private bool ReadCorner(int faceAt, out int corner)
    {
        corner = 0;
        var start = _cursor.SkipWord();
        var at = start;
        var bytes = _cursor.Bytes;
        var negative = bytes[at] == '-';
        if (negative || bytes[at] == '+') at++;
        var digits = at;
        long index = 0;
        for (; at < _cursor.At && (uint)(bytes[at] - '0') <= 9; at++)
        {
            if (index <= int.MaxValue) index = index * 10 + (bytes[at] - '0');
        }
        if (at == digits || (at < _cursor.At && bytes[at] != '/'))
            return source.ErrorInText("mesh.syntax", "A vertex of a face must be a number or numbers separated by slashes.", start);
        var absolute = negative ? _vertices - index : index - 1;
        if (absolute < 0 || absolute >= int.MaxValue)
            return source.ErrorInText("mesh.index", "A face uses a vertex that does not exist.", start);
        corner = (int)absolute;
        if (corner > _largest) (_largest, _largestAt) = (corner, faceAt);
        return true;
    }

    private void Push(int a, int b, int c)
    {
        if (_used + 3 > _corners.Length)
        {
            source.Afford(2L * _used / 3);
            Array.Resize(ref _corners, _corners.Length * 2);
        }
        _corners[_used] = a;
        _corners[_used + 1] = b;
        _corners[_used + 2] = c;
        _used += 3;
    }

    private void Other(int start)
    {
        if (_cursor.Bytes[start] == '#') return;
        if (_cursor.WordIs(start, "o") || (_cursor.WordIs(start, "g") && _name.Length == 0))
        {
            var at = _cursor.At;
            if (_name.Length == 0) _name = _cursor.RestOfLine();
            _cursor.At = at;
            return;
        }
        var word = _cursor.At - start <= 12 ? System.Text.Encoding.ASCII.GetString(_cursor.Bytes, start, _cursor.At - start) : "";
        switch (word)
        {
            case "vt" or "vn" or "vp" or "g" or "s" or "l" or "p" or "mg" or "usemtl" or "mtllib" or "usemap" or "maplib" or "lod" or "bevel"
                or "c_interp" or "d_interp" or "shadow_obj" or "trace_obj" or "ctech" or "stech":
                return;
            case "cstype" or "deg" or "bmat" or "step" or "curv" or "curv2" or "surf" or "parm" or "trim" or "hole" or "scrv" or "sp" or "end" or "con":
                const string Message = "Free-form curves and surfaces are ignored. Only polygons are read from OBJ files.";
                source.Note(Severity.Warning, "mesh.unsupported", Message, source.PlaceInText(start));
                return;
            default:
                source.Note(Severity.Note, "mesh.ignored", "A line with an unknown keyword is ignored.", source.PlaceInText(start));
                return;
        }
    }
}
