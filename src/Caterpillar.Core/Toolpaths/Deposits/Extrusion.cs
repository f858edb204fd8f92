namespace Caterpillar.Toolpaths;

/// <summary>
/// A straight piece of printed material seen from above: the path of the nozzle tip, which is its top, and half its width. Its footprint is a stadium.
/// </summary>
internal struct Extrusion
{
    public double Ax, Ay, Az, Bx, By, Bz, Half;

    // A number of the caller, for what it is.
    public int Tag;

    // Another one goes on downward from its lower end, beyond which nothing of this one lies.
    public bool IsJoined;

    // Rise for each mm seen from above that counts as level.
    private const double LevelRise = 0.03;

    public readonly double Top => Math.Max(Az, Bz);

    public readonly Vec3 A => new(Ax, Ay, Az);

    public readonly Vec3 B => new(Bx, By, Bz);

    /// <summary>True if it goes up or down, so that its ends are not as high as what is before them.</summary>
    public readonly bool IsSloped => (Bz - Az) * (Bz - Az) > LevelRise * LevelRise * ((Bx - Ax) * (Bx - Ax) + (By - Ay) * (By - Ay));

    public static Extrusion Of(Vec3 a, Vec3 b, double half, int tag = -1, bool isJoined = false)
        => new() { Ax = a.X, Ay = a.Y, Az = a.Z, Bx = b.X, By = b.Y, Bz = b.Z, Half = half, Tag = tag, IsJoined = isJoined };

    /// <summary>Highest top of the part whose footprint comes within a distance of a segment, seen from above. Negative infinity = none.</summary>
    public readonly double TopWithin(Vec3 a, Vec3 b, double distance)
    {
        var reach = distance + Half;
        if (!StadiumClip.TryClip(Ax, Ay, Bx - Ax, By - Ay, a, b, reach, out var from, out var to)) return double.NegativeInfinity;
        return Math.Max(Az + (Bz - Az) * from, to >= 1 ? Bz : Az + (Bz - Az) * to);
    }

    /// <summary>True if the rectangles of its axis and a segment are farther apart, which is faster than clipping.</summary>
    public readonly bool IsBeyond(in Vec3 a, in Vec3 b, double reach)
        => Math.Abs(Ax + Bx - a.X - b.X) > Math.Abs(Bx - Ax) + Math.Abs(b.X - a.X) + 2 * reach
        || Math.Abs(Ay + By - a.Y - b.Y) > Math.Abs(By - Ay) + Math.Abs(b.Y - a.Y) + 2 * reach;

    /// <summary>Top at its nearest point to a point, seen from above, if within a distance of its footprint. Otherwise negative infinity.</summary>
    public readonly double TopAt(Vec3 p, double distance)
    {
        double dx = Bx - Ax, dy = By - Ay;
        var square = dx * dx + dy * dy;
        var reach = distance + Half;
        // Most are clearly beside it, which is told without a division.
        var aside = (p.X - Ax) * dy - (p.Y - Ay) * dx;
        if (aside * aside > (reach * reach + 1e-6) * square) return double.NegativeInfinity;
        var t = square > 0 ? ((p.X - Ax) * dx + (p.Y - Ay) * dy) / square : (Az >= Bz ? 0 : 1);
        if (IsJoined && (Bz > Az ? t < 0 : t > 1) && IsSloped) return double.NegativeInfinity;
        t = Math.Min(1, Math.Max(0, t));
        double ex = p.X - Ax - dx * t, ey = p.Y - Ay - dy * t;
        return ex * ex + ey * ey <= reach * reach ? t >= 1 ? Bz : Az + (Bz - Az) * t : double.NegativeInfinity;
    }
}

/// <summary>The part of a segment inside the stadium around another segment, seen from above.</summary>
internal static class StadiumClip
{
    /// <summary>
    /// Parameters from 0 to 1 along the segment from (x, y) by (dx, dy), between which it is within <paramref name="reach"/> mm of the segment from a to b. The
    /// part is one piece, because a stadium is convex: the union of the pieces in its rectangle and its two discs.
    /// </summary>
    public static bool TryClip(double x, double y, double dx, double dy, Vec3 a, Vec3 b, double reach, out double from, out double to)
    {
        from = double.PositiveInfinity;
        to = double.NegativeInfinity;
        Disc(x - a.X, y - a.Y, dx, dy, reach, ref from, ref to);
        double ux = b.X - a.X, uy = b.Y - a.Y;
        var length = Math.Sqrt(ux * ux + uy * uy);
        if (length > 0)
        {
            Disc(x - b.X, y - b.Y, dx, dy, reach, ref from, ref to);
            ux /= length;
            uy /= length;
            double px = x - a.X, py = y - a.Y;
            double low = 0, high = 1;
            if (FlatSegment.Slab(px * ux + py * uy, dx * ux + dy * uy, 0, length, ref low, ref high)
                && FlatSegment.Slab(py * ux - px * uy, dy * ux - dx * uy, -reach, reach, ref low, ref high))
            {
                from = Math.Min(from, low);
                to = Math.Max(to, high);
            }
        }
        return from <= to;
    }

    private static void Disc(double px, double py, double dx, double dy, double radius, ref double from, ref double to)
    {
        var a = dx * dx + dy * dy;
        var c = px * px + py * py - radius * radius;
        if (!(a > 0))
        {
            if (c > 0) return;
            from = 0;
            to = 1;
            return;
        }
        var b = px * dx + py * dy;
        var root = b * b - a * c;
        if (root < 0) return;
        root = Math.Sqrt(root);
        var low = Math.Max(0, (-b - root) / a);
        var high = Math.Min(1, (-b + root) / a);
        if (low > high) return;
        from = Math.Min(from, low);
        to = Math.Max(to, high);
    }
}

/// <summary>Extrusions by number, in chunks. Numbers without a bin are reused.</summary>
internal sealed class ExtrusionStore
{
    private const int ChunkBits = 12;
    private const int ChunkMask = (1 << ChunkBits) - 1;
    private Extrusion[][] _chunks = [];

    // Number of bins that refer to each; 0 if it is free.
    private int[] _users = [];

    // Number of the query that has last seen each.
    private int[] _seen = [];
    private int _query;
    private int[] _free = new int[64];
    private int _freeCount;
    private int _next;

    /// <summary>Number of stored extrusions.</summary>
    public int Count => _next - _freeCount;

    public ref Extrusion this[int index] => ref _chunks[index >> ChunkBits][index & ChunkMask];

    public int Add(in Extrusion extrusion)
    {
        var index = _freeCount > 0 ? _free[--_freeCount] : _next++;
        Buffers.Reserve(ref _chunks, (index >> ChunkBits) + 1);
        Buffers.Reserve(ref _users, index + 1);
        Buffers.Reserve(ref _seen, index + 1);
        _chunks[index >> ChunkBits] ??= new Extrusion[1 << ChunkBits];
        this[index] = extrusion;
        return index;
    }

    /// <summary>A new query has seen none of them.</summary>
    public void BeginQuery() => _query++;

    /// <summary>Whether the query has not seen an extrusion before.</summary>
    public bool IsNew(int index)
    {
        if (_seen[index] == _query) return false;
        _seen[index] = _query;
        return true;
    }

    /// <summary>Counts one more bin with an extrusion.</summary>
    public void Use(int index) => _users[index]++;

    /// <summary>Counts one bin less.</summary>
    public void Release(int index)
    {
        if (--_users[index] > 0) return;
        if (_freeCount == _free.Length) Array.Resize(ref _free, _freeCount * 2);
        _free[_freeCount++] = index;
    }
}
