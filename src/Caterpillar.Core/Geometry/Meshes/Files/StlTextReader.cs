namespace Caterpillar.Geometry;

/// <summary>
/// Reads ASCII STL: words in any case, any white space and line ends, several solids (taken as one mesh, so that a surface in patches closes).
/// </summary>
internal sealed class StlTextReader(MeshSource source)
{
    private readonly TextCursor _cursor = new(source.Bytes, ByteOrderMark.Length(source.Bytes), source.Length);
    private readonly MeshBuilder _builder = new(source.Length / 400 + 16, source.Length / 200);
    private string _name = "";
    private bool _open;

    // Where the facet at hand begins, or −1, and the vertices of the last three of its corners.
    private int _facetAt = -1;
    private int _corners;
    private int _a;
    private int _b;
    private int _c;

    /// <summary>True if the file begins with "solid" and continues with a facet or the end of the solid.</summary>
    public static bool LooksLikeText(byte[] bytes)
    {
        var cursor = new TextCursor(bytes, ByteOrderMark.Length(bytes), bytes.Length);
        cursor.SkipSpace();
        var start = cursor.SkipWord();
        if (!cursor.WordIs(start, "solid")) return false;
        var limit = Math.Min(bytes.Length, start + 4096);
        for (var i = start + 5; i < limit; i++)
        {
            if (bytes[i] == 0) return false;
            if (bytes[i] <= ' ') continue;
            cursor.At = i;
            start = cursor.SkipWord();
            if (cursor.WordIs(start, "facet") || cursor.WordIs(start, "endsolid")) return true;
            i = Math.Max(i, cursor.At - 1);
        }
        return bytes.Length <= limit;
    }

    /// <summary>Adds the mesh of a file; false after an error.</summary>
    public static bool Read(MeshSource source, List<NamedMesh> meshes) => new StlTextReader(source).ReadAll(meshes);

    private bool ReadAll(List<NamedMesh> meshes)
    {
        for (var words = 0; _cursor.SkipSpace(); words++)
        {
            if ((words & 0xFFFF) == 0)
            {
                source.Pulse(_cursor.At, source.Length);
                source.Afford(_builder.TriangleCount);
            }
            if (!Word(_cursor.SkipWord())) return false;
        }
        if (_facetAt >= 0) return Fail("The file ends inside a facet.", source.Length, "mesh.truncated");
        if (_open)
        {
            var end = source.PlaceInText(source.Length);
            source.Note(Severity.Warning, "mesh.truncated", "The file ends without \"endsolid\" and may be incomplete.", end);
        }
        var name = _name.Length > 0 ? _name : MeshReader.PlainName(source.Name);
        meshes.Add(new NamedMesh(name, _builder.ToMesh(source.Name, true, source.Diagnostics)));
        return true;
    }

    // Takes a word with what belongs to it; false after an error.
    private bool Word(int word)
    {
        if (_cursor.WordIs(word, "vertex")) return Vertex(word);
        if (_cursor.WordIs(word, "facet")) return Facet(word);
        if (_cursor.WordIs(word, "endfacet")) return EndFacet(word);
        if (_cursor.WordIs(word, "normal"))
        {
            for (var i = 0; i < 3 && _cursor.SkipSpace(); i++) _cursor.SkipWord();
            return true;
        }
        if (_facetAt < 0 && _cursor.WordIs(word, "solid"))
        {
            var given = _cursor.RestOfLine();
            if (_name.Length == 0) _name = given;
            _open = true;
            return true;
        }
        if (_facetAt < 0 && _cursor.WordIs(word, "endsolid"))
        {
            _cursor.SkipLine();
            _open = false;
            return true;
        }
        var isKnown = _cursor.WordIs(word, "outer") || _cursor.WordIs(word, "loop") || _cursor.WordIs(word, "endloop");
        return isKnown || Fail("Unknown word in an ASCII STL file.", word);
    }

    private bool Vertex(int word)
    {
        if (_facetAt < 0) return Fail("A vertex is outside a facet.", word);
        if (_corners == 3) return Fail("A facet has more than three vertices.", word);
        if (!_cursor.ReadPoint(withinLine: false, out var x, out var y, out var z))
            return _cursor.AtEnd ? Fail("The file ends inside a vertex.", source.Length, "mesh.truncated") : Fail("A coordinate is not a number.", _cursor.At);
        (_a, _b, _c) = (_b, _c, _builder.AddVertex(x, y, z));
        _corners++;
        return true;
    }

    private bool Facet(int word)
    {
        if (_facetAt >= 0) return Fail("A facet begins before the previous one has ended.", word);
        _facetAt = word;
        _corners = 0;
        return true;
    }

    private bool EndFacet(int word)
    {
        if (_facetAt < 0) return Fail("A facet ends without a beginning.", word);
        if (_corners != 3) return Fail("A facet has fewer than three vertices.", word);
        _builder.AddTriangle(_a, _b, _c);
        _facetAt = -1;
        return true;
    }

    private bool Fail(string message, int at, string code = "mesh.syntax") => source.ErrorInText(code, message, at);
}
