using System;
using System.Collections.Generic;
using System.Threading;
using System.Threading.Tasks;
using Caterpillar.Geometry;

namespace Caterpillar.Slicing;

/// <summary>
/// Bends a mesh so that the layers of a field are flat. Triangles are divided until straight edges match their bent image within a tolerance; an edge is
/// divided once for both of its triangles, so a closed mesh stays closed.
/// </summary>
internal sealed class MeshFlattener
{
    private const int MaxTriangles = 12_000_000;

    // Uneven, so that waves do not hide between them.
    private static readonly double[] Tests = [0.5, 0.27, 0.81];
    private readonly LayerField _field;
    private readonly IReadOnlyList<double> _creases;
    private readonly double _tolerance;
    private readonly ParallelOptions _options;
    private readonly List<Vec3> _part;
    private readonly List<Vec3> _flat;
    private readonly Dictionary<long, int> _states = [];
    private readonly List<(int A, int B, long Key)> _untested = [];
    private readonly List<(int A, int B, int C)> _pieces = [];
    private List<Face> _faces;

    private MeshFlattener(TriMesh mesh, LayerField field, double tolerance, ParallelOptions options)
    {
        _field = field;
        _creases = field.Creases;
        _tolerance = tolerance;
        _options = options;
        _part = new List<Vec3>(mesh.RawVertices);
        _flat = new List<Vec3>(new Vec3[mesh.VertexCount]);
        var bent = new Vec3[mesh.VertexCount];
        Parallel.For(0, bent.Length, options, i => bent[i] = field.ToFlat(mesh.RawVertices[i]));
        for (var i = 0; i < bent.Length; i++) _flat[i] = bent[i];
        _faces = new List<Face>(mesh.TriangleCount);
        var triangles = mesh.RawTriangles;
        for (var t = 0; t < triangles.Length; t += 3) _faces.Add(new Face(triangles[t], triangles[t + 1], triangles[t + 2], false));
    }

    /// <summary>The bent mesh; null where it would take more than 12 million triangles.</summary>
    /// <exception cref="OperationCanceledException">The call was cancelled.</exception>
    public static TriMesh? Flatten(TriMesh mesh, LayerField field, double tolerance, int threads, CancellationToken cancel)
    {
        var options = new ParallelOptions { CancellationToken = cancel, MaxDegreeOfParallelism = threads > 0 ? threads : -1 };
        var flattener = new MeshFlattener(mesh, field, tolerance, options);
        while (flattener.Refine())
        {
            if (flattener._faces.Count > MaxTriangles) return null;
            cancel.ThrowIfCancellationRequested();
        }
        return flattener.Result();
    }

    // One round: false when nothing had to be divided.
    private bool Refine()
    {
        _untested.Clear();
        foreach (var face in _faces)
        {
            Ask(face.A, face.B);
            Ask(face.B, face.C);
            Ask(face.C, face.A);
        }
        var middles = new (bool Divide, Vec3 Part, Vec3 Flat)[_untested.Count];
        Parallel.For(0, middles.Length, _options, i => middles[i] = Test(_untested[i].A, _untested[i].B));
        for (var i = 0; i < middles.Length; i++)
        {
            if (middles[i].Divide) _states[_untested[i].Key] = Add(middles[i].Part, middles[i].Flat);
        }
        var bent = new bool[_faces.Count];
        Parallel.For(0, bent.Length, _options, i => bent[i] = !_faces[i].Tested && IsWhole(_faces[i]) && !IsFlat(_faces[i]));
        for (var i = 0; i < bent.Length; i++)
        {
            if (bent[i]) Divide(_faces[i]);
            else if (IsWhole(_faces[i])) _faces[i] = _faces[i] with { Tested = true };
        }
        while (DivideLongest())
        {
        }
        var next = new List<Face>(_faces.Count);
        foreach (var face in _faces)
        {
            _pieces.Clear();
            TriangleSplit.Add(_part, (face.A, face.B, face.C), (State(face.A, face.B), State(face.B, face.C), State(face.C, face.A)), _pieces);
            if (_pieces.Count == 1) next.Add(face);
            else foreach (var (a, b, c) in _pieces) next.Add(new Face(a, b, c, false));
        }
        var divided = next.Count > _faces.Count;
        _faces = next;
        return divided;
    }

    // Multiplied by an odd number, which keeps keys apart and spreads their hashes: those of neighbors would be almost alike.
    private static long Key(int a, int b) => unchecked((a < b ? ((long)a << 32) | (uint)b : ((long)b << 32) | (uint)a) * -7046029254386353131L);

    // −1 for an edge that stays whole, else the number of its middle.
    private int State(int a, int b) => _states[Key(a, b)];

    private void Ask(int a, int b)
    {
        var key = Key(a, b);
        if (_states.ContainsKey(key)) return;
        _states.Add(key, -1);
        _untested.Add(a < b ? (a, b, key) : (b, a, key));
    }

    private int Add(Vec3 part, Vec3 flat)
    {
        _part.Add(part);
        _flat.Add(flat);
        return _part.Count - 1;
    }

    private (bool Divide, Vec3 Part, Vec3 Flat) Test(int a, int b)
    {
        var middle = Middle(a, b);
        var divide = _field.Span(_part[b] - _part[a]) > _field.Detail;
        var flat = _field.ToFlat(middle);
        // Shorter ones would not be seen in print.
        if (divide || _part[a].DistanceTo(_part[b]) < _tolerance) return (divide, middle, flat);
        foreach (var t in Tests)
        {
            var image = _field.ToFlat(Vec3.Lerp(_part[a], _part[b], t));
            if (image.DistanceTo(Vec3.Lerp(_flat[a], _flat[b], t)) > _tolerance) return (true, middle, flat);
        }
        return (false, middle, flat);
    }

    // Where an edge is divided: where it crosses a crease of the field, else in its middle.
    private Vec3 Middle(int a, int b)
    {
        foreach (var crease in _creases)
        {
            double low = _flat[a].Z - crease, high = _flat[b].Z - crease;
            if (low < 0 == high < 0 || Math.Min(Math.Abs(low), Math.Abs(high)) < _tolerance) continue;
            double from = 0, to = 1, t = 0.5;
            for (var i = 0; i < 20; i++)
            {
                t = from + (to - from) * low / (low - high);
                var at = _field.Value(Vec3.Lerp(_part[a], _part[b], t)) - crease;
                if (Math.Abs(at) < 1e-7 || double.IsNaN(at)) break;
                if (at < 0 == low < 0) (from, low) = (t, at);
                else (to, high) = (t, at);
            }
            if (t > 0.001 && t < 0.999) return Vec3.Lerp(_part[a], _part[b], t);
        }
        return Vec3.Lerp(_part[a], _part[b], 0.5);
    }

    private bool IsWhole(Face face) => State(face.A, face.B) < 0 && State(face.B, face.C) < 0 && State(face.C, face.A) < 0;

    private bool IsFlat(Face face)
    {
        // Narrow ones have no inside that could differ from their edges.
        Vec3 a = _part[face.A], b = _part[face.B], c = _part[face.C];
        var longest = Math.Max((b - a).LengthSquared, Math.Max((c - b).LengthSquared, (a - c).LengthSquared));
        if (Vec3.Cross(b - a, c - a).LengthSquared < 16 * _tolerance * _tolerance * longest) return true;
        return IsFlat(face, 1.0 / 3, 1.0 / 3) && IsFlat(face, 0.2, 0.2) && IsFlat(face, 0.6, 0.2) && IsFlat(face, 0.2, 0.6);
    }

    private bool IsFlat(Face face, double u, double v)
    {
        var w = 1 - u - v;
        var image = _field.ToFlat(_part[face.A] * u + _part[face.B] * v + _part[face.C] * w);
        return !(image.DistanceTo(_flat[face.A] * u + _flat[face.B] * v + _flat[face.C] * w) > _tolerance);
    }

    // A triangle that is divided is divided across its longest edge, too: so none becomes ever narrower (Rivara, 1984).
    private bool DivideLongest()
    {
        var found = false;
        foreach (var face in _faces)
        {
            if (IsWhole(face)) continue;
            double ab = Square(face.A, face.B), bc = Square(face.B, face.C), ca = Square(face.C, face.A);
            var (a, b) = ab >= bc && ab >= ca ? (face.A, face.B) : bc >= ca ? (face.B, face.C) : (face.C, face.A);
            if (State(a, b) >= 0) continue;
            Divide(a, b);
            found = true;
        }
        return found;
    }

    private double Square(int a, int b) => (_part[a] - _part[b]).LengthSquared;

    private void Divide(Face face)
    {
        const double Least = 4;
        if (Square(face.A, face.B) > Least * _tolerance * _tolerance) Divide(face.A, face.B);
        if (Square(face.B, face.C) > Least * _tolerance * _tolerance) Divide(face.B, face.C);
        if (Square(face.C, face.A) > Least * _tolerance * _tolerance) Divide(face.C, face.A);
    }

    private void Divide(int a, int b)
    {
        if (State(a, b) >= 0) return;
        var middle = a < b ? Middle(a, b) : Middle(b, a);
        _states[Key(a, b)] = Add(middle, _field.ToFlat(middle));
    }

    private TriMesh Result()
    {
        var triangles = new int[_faces.Count * 3];
        for (var i = 0; i < _faces.Count; i++)
        {
            triangles[3 * i] = _faces[i].A;
            triangles[3 * i + 1] = _faces[i].B;
            triangles[3 * i + 2] = _faces[i].C;
        }
        return TriMesh.Own(_flat.ToArray(), triangles);
    }

    private readonly record struct Face(int A, int B, int C, bool Tested);
}
