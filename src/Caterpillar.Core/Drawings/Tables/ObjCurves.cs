namespace Caterpillar.Drawings;

/// <summary>The polylines of Wavefront OBJ: <c>v</c> and <c>l</c> with positive and negative numbers of vertices, named by <c>o</c> and <c>g</c>.</summary>
internal sealed class ObjCurves(CurveSource source)
{
    private readonly TextCursor _cursor = new(source.Bytes, ByteOrderMark.Length(source.Bytes), source.Bytes.Length);
    private readonly List<Vec3> _vertices = [];
    private int _line = 1;
    private int _lineStart;
    private string _name = "";

    public static void Read(CurveSource source) => new ObjCurves(source).ReadAll();

    private void ReadAll()
    {
        var counted = 0;
        while (_cursor.SkipSpace())
        {
            // Lines are counted up to the cursor, also those that a backslash continues.
            for (; counted < _cursor.At; counted++)
            {
                if (_cursor.Bytes[counted] != '\n') continue;
                _line++;
                _lineStart = counted + 1;
                if ((_line & 0x3FFF) == 0) source.Pulse(counted, _cursor.End);
            }
            var start = _cursor.SkipWord();
            var good = true;
            if (_cursor.WordIs(start, "v")) good = Vertex();
            else if (_cursor.WordIs(start, "l")) good = Line(start);
            else if (_cursor.WordIs(start, "o") || _cursor.WordIs(start, "g")) good = Name();
            else Other(start);
            if (!good) return;
            while (_cursor.SkipSpaces()) _cursor.SkipWord();
            _cursor.SkipLine();
        }
    }

    private bool Vertex()
    {
        if (!_cursor.ReadPoint(withinLine: true, out var x, out var y, out var z))
            return source.Fail("curves.obj", "A vertex needs three numbers.", At(_cursor.At));
        _vertices.Add(new Vec3(x, y, z) * source.Options.UnitLength);
        return true;
    }

    private bool Line(int lineAt)
    {
        var points = new List<Vec3>();
        while (_cursor.SkipSpaces())
        {
            if (_cursor.Bytes[_cursor.At] == '#') break;
            var start = _cursor.SkipWord();
            var end = Array.IndexOf(_cursor.Bytes, (byte)'/', start, _cursor.At - start);
            if (!NumberReader.TryParse(_cursor.Bytes, start, end < 0 ? _cursor.At : end, out var number) || number != Math.Floor(number))
                return source.Fail("curves.obj", "The points of a line must be vertex numbers.", At(start));
            var index = number < 0 ? _vertices.Count + number : number - 1;
            if (!(index >= 0 && index < _vertices.Count))
                return source.Fail("curves.obj", $"A line uses vertex {NumberFormatter.Format(number, 0)}, which is not defined before it.", At(start));
            var point = _vertices[(int)index];
            if (!point.IsFinite)
                return source.Fail("curves.not_finite", "A line uses a vertex that is not finite.", At(start));
            points.Add(point);
        }
        var place = At(lineAt);
        var curve = source.Polyline(points.ToArray(), false, place, out _);
        if (curve is not null) source.Curves.Add(new UserCurve(curve) { Name = _name, Source = place });
        return true;
    }

    // The rest of the line; the line end stays for the caller.
    private bool Name()
    {
        var at = _cursor.At;
        _name = _cursor.SkipSpaces() ? _cursor.RestOfLine() : "";
        _cursor.At = at;
        return true;
    }

    private void Other(int start)
    {
        if (_cursor.Bytes[start] == '#') return;
        if (_cursor.WordIs(start, "f")) source.Diagnostics.Add(Severity.Note, "curves.faces", "Faces are not curves and are ignored.", At(start));
        else if (_cursor.WordIs(start, "curv") || _cursor.WordIs(start, "cstype"))
            source.Diagnostics.Add(Severity.Warning, "curves.unsupported", "Free-form OBJ curves are ignored. Only l elements are read.", At(start));
    }

    private SourceLocation At(int offset) => source.Place(_line, offset - _lineStart + 1);
}
