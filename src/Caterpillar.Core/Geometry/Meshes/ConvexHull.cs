namespace Caterpillar.Geometry;

/// <summary>
/// The convex hull of points as triangles that face outwards (quickhull: Barber, Dobkin, Huhdanpaa 1996). Points within a billionth of the extent of a
/// face belong to it.
/// </summary>
internal sealed class ConvexHull(IReadOnlyList<Vec3> points, double tolerance)
{
    private readonly List<Face> _faces = [];

    /// <summary>Triples of point numbers; none where the points lie in a plane.</summary>
    public static IReadOnlyList<(int A, int B, int C)> Of(IReadOnlyList<Vec3> points)
    {
        var bounds = Bounds.Of(points);
        var hull = new ConvexHull(points, bounds.IsEmpty ? 0 : 1e-9 * bounds.Size.Length);
        if (points.Count < 4 || !hull.Begin(bounds)) return [];
        hull.Grow();
        return [.. hull._faces.Where(f => f.IsAlive).Select(f => (f.A, f.B, f.C))];
    }

    // A large tetrahedron: the two farthest points of an axis, the farthest from their line, the farthest from that plane.
    private bool Begin(Bounds bounds)
    {
        var size = bounds.Size;
        Func<Vec3, double> along = size.X >= size.Y && size.X >= size.Z ? p => p.X : size.Y >= size.Z ? p => p.Y : p => p.Z;
        int a = Farthest(p => -along(p)), b = Farthest(along);
        var axis = points[b] - points[a];
        var c = Farthest(p => Vec3.Cross(p - points[a], axis).Length);
        var normal = Vec3.Cross(axis, points[c] - points[a]).Unit();
        var d = Farthest(p => Math.Abs(Vec3.Dot(p - points[a], normal)));
        var height = Vec3.Dot(points[d] - points[a], normal);
        if (!(Math.Abs(height) > tolerance)) return false;
        if (height > 0) (b, c) = (c, b);
        Face[] faces = [new(points, a, b, c), new(points, a, d, b), new(points, b, d, c), new(points, c, d, a)];
        for (var i = 0; i < 4; i++)
        {
            for (var j = 0; j < 4; j++) faces[i].LinkTo(faces[j]);
        }
        _faces.AddRange(faces);
        for (var p = 0; p < points.Count; p++) Assign(p, faces);
        return true;
    }

    private int Farthest(Func<Vec3, double> measure)
    {
        var best = 0;
        for (var i = 1; i < points.Count; i++)
        {
            if (measure(points[i]) > measure(points[best])) best = i;
        }
        return best;
    }

    private void Grow()
    {
        var visible = new List<Face>();
        var horizon = new List<(Face Beyond, int From, int To)>();
        for (var next = 0; next < _faces.Count; next++)
        {
            var face = _faces[next];
            if (!face.IsAlive || face.Outside.Count == 0) continue;
            visible.Clear();
            horizon.Clear();
            Look(face, face.Eye, visible, horizon);
            var cone = new List<Face>(horizon.Count);
            foreach (var (beyond, from, to) in horizon)
            {
                var added = new Face(points, from, to, face.Eye);
                added.LinkTo(beyond);
                beyond.LinkTo(added);
                cone.Add(added);
            }
            var starts = new Dictionary<int, Face>();
            foreach (var added in cone) starts[added.A] = added;
            foreach (var added in cone)
            {
                if (!starts.TryGetValue(added.B, out var follower)) continue;
                added.LinkTo(follower);
                follower.LinkTo(added);
            }
            _faces.AddRange(cone);
            foreach (var old in visible)
            {
                foreach (var p in old.Outside)
                {
                    if (p != face.Eye) Assign(p, cone);
                }
                old.Outside.Clear();
            }
        }
    }

    // Faces that see the point, and the edges around them; the stack keeps deep hulls from overflowing.
    private void Look(Face first, int eye, List<Face> visible, List<(Face Beyond, int From, int To)> horizon)
    {
        var stack = new Stack<Face>();
        first.IsAlive = false;
        stack.Push(first);
        while (stack.Count > 0)
        {
            var face = stack.Pop();
            visible.Add(face);
            for (var k = 0; k < 3; k++)
            {
                var other = face.Neighbors[k]!;
                if (!other.IsAlive) continue;
                if (other.Distance(points[eye]) > tolerance)
                {
                    other.IsAlive = false;
                    stack.Push(other);
                }
            }
        }
        foreach (var face in visible)
        {
            for (var k = 0; k < 3; k++)
            {
                if (face.Neighbors[k]!.IsAlive) horizon.Add((face.Neighbors[k]!, face.Corner(k), face.Corner(k + 1)));
            }
        }
    }

    private void Assign(int point, IReadOnlyList<Face> faces)
    {
        foreach (var face in faces)
        {
            var distance = face.Distance(points[point]);
            if (!(distance > tolerance)) continue;
            face.Outside.Add(point);
            if (distance > face.EyeDistance) (face.Eye, face.EyeDistance) = (point, distance);
            return;
        }
    }

    private sealed class Face(IReadOnlyList<Vec3> points, int a, int b, int c)
    {
        private readonly Vec3 _origin = points[a];
        private readonly Vec3 _normal = Vec3.Cross(points[b] - points[a], points[c] - points[a]).Unit();

        public int A => a;

        public int B => b;

        public int C => c;

        public bool IsAlive { get; set; } = true;

        public List<int> Outside { get; } = [];

        public int Eye { get; set; }

        public double EyeDistance { get; set; }

        // Over the edges AB, BC, CA.
        public Face?[] Neighbors { get; } = new Face?[3];

        public int Corner(int k) => k % 3 == 0 ? a : k % 3 == 1 ? b : c;

        public double Distance(Vec3 p) => Vec3.Dot(p - _origin, _normal);

        public void LinkTo(Face other)
        {
            for (var k = 0; k < 3; k++)
            {
                for (var m = 0; m < 3; m++)
                {
                    if (Corner(k) == other.Corner(m + 1) && Corner(k + 1) == other.Corner(m)) Neighbors[k] = other;
                }
            }
        }
    }
}
