using System;
using System.Collections.Generic;
using Caterpillar.Basics;
using Caterpillar.Files;

namespace Caterpillar.Geometry;

/// <summary>
/// Reads ASCII STL: words in any case, any white space and line ends, several solids (taken as one mesh, so that a surface in patches closes).
/// </summary>
internal static class StlTextReader
{
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

    public static bool Read(MeshSource source, List<NamedMesh> meshes)
    {
        var cursor = new TextCursor(source.Bytes, ByteOrderMark.Length(source.Bytes), source.Length);
        var triangles = source.Length / 200;
        var builder = new MeshBuilder(triangles / 2 + 16, triangles);
        var name = "";
        var corners = 0;
        int a = 0, b = 0, c = 0;
        var facetAt = -1;
        var open = false;
        for (var words = 0; cursor.SkipSpace(); words++)
        {
            if ((words & 0xFFFF) == 0)
            {
                source.Pulse(cursor.At, source.Length);
                source.Afford(builder.TriangleCount);
            }
            var start = cursor.SkipWord();
            if (cursor.WordIs(start, "vertex"))
            {
                if (facetAt < 0 || corners == 3)
                {
                    source.ErrorInText("mesh.syntax", facetAt < 0 ? "A vertex is outside a facet." : "A facet has more than three vertices.", start);
                    return false;
                }
                if (!ReadPoint(cursor, out var x, out var y, out var z)) return WrongNumber(source, cursor);
                (a, b, c) = (b, c, builder.AddVertex(x, y, z));
                corners++;
            }
            else if (cursor.WordIs(start, "facet"))
            {
                if (facetAt >= 0)
                {
                    source.ErrorInText("mesh.syntax", "A facet begins before the previous one has ended.", start);
                    return false;
                }
                facetAt = start;
                corners = 0;
            }
            else if (cursor.WordIs(start, "endfacet"))
            {
                if (facetAt < 0 || corners != 3)
                {
                    var message = facetAt < 0 ? "A facet ends that has not begun." : "A facet has fewer than three vertices.";
                    source.ErrorInText("mesh.syntax", message, start);
                    return false;
                }
                builder.AddTriangle(a, b, c);
                facetAt = -1;
            }
            else if (cursor.WordIs(start, "normal"))
            {
                for (var i = 0; i < 3 && cursor.SkipSpace(); i++) cursor.SkipWord();
            }
            else if (cursor.WordIs(start, "solid") && facetAt < 0)
            {
                var given = cursor.RestOfLine();
                if (name.Length == 0) name = given;
                open = true;
            }
            else if (cursor.WordIs(start, "endsolid") && facetAt < 0)
            {
                cursor.SkipLine();
                open = false;
            }
            else if (!cursor.WordIs(start, "outer") && !cursor.WordIs(start, "loop") && !cursor.WordIs(start, "endloop"))
            {
                source.ErrorInText("mesh.syntax", "A word does not belong in an ASCII STL file.", start);
                return false;
            }
        }
        if (facetAt >= 0)
        {
            source.ErrorInText("mesh.truncated", "The file ends inside a facet.", source.Length);
            return false;
        }
        if (open)
        {
            var end = source.PlaceInText(source.Length);
            source.Note(Severity.Warning, "mesh.truncated", "The file ends without \"endsolid\"; it may be incomplete.", end);
        }
        meshes.Add(new NamedMesh(name.Length > 0 ? name : MeshReader.PlainName(source.Name), builder.ToMesh(source.Name, true, source.Diagnostics)));
        return true;
    }

    private static bool ReadPoint(TextCursor cursor, out double x, out double y, out double z)
    {
        y = z = 0;
        cursor.SkipSpace();
        if (!cursor.ReadNumber(out x)) return false;
        cursor.SkipSpace();
        if (!cursor.ReadNumber(out y)) return false;
        cursor.SkipSpace();
        return cursor.ReadNumber(out z);
    }

    private static bool WrongNumber(MeshSource source, TextCursor cursor)
    {
        if (cursor.AtEnd) source.ErrorInText("mesh.truncated", "The file ends inside a vertex.", source.Length);
        else source.ErrorInText("mesh.syntax", "A coordinate is not a number.", cursor.At);
        return false;
    }
}
