namespace Caterpillar.Display;

/// <summary>
/// Extrusions as a mesh for display: along each segment a tube with the true width and height. Its top is the path of the nozzle. Corners are mitered, sharp
/// corners are capped. Material extruded in place is a ball or a disc below the nozzle.
/// </summary>
public sealed class ExtrusionMesh
{
    // Corners of the cross-section, counterclockwise seen along the path, in half widths and heights: a stadium with cut corners.
    private static readonly (double Side, double Down)[] Section =
        [(-0.6, 0), (-1, 0.25), (-1, 0.75), (-0.6, 1), (0.6, 1), (1, 0.75), (1, 0.25), (0.6, 0)];

    private const double ArcTolerance = 0.05;
    private const double LeastCosine = 0.3;
    private readonly List<Vec3> _vertices = [];
    private readonly List<int> _quads = [];
    private readonly List<int> _moves = [];

    /// <summary>The vertices, mm.</summary>
    public IReadOnlyList<Vec3> Vertices => _vertices;

    /// <summary>Four vertex indices per face, counterclockwise seen from outside.</summary>
    public IReadOnlyList<int> Quads => _quads;

    /// <summary>The move of each vertex.</summary>
    public IReadOnlyList<int> Moves => _moves;

    /// <summary>The extrusions of the moves from <paramref name="first"/> to before <paramref name="end"/>.</summary>
    /// <exception cref="ArgumentOutOfRangeException">The toolpath has no moves with these numbers.</exception>
    public static ExtrusionMesh Of(Toolpath toolpath, int first, int end)
    {
        if (toolpath is null) throw new ArgumentNullException(nameof(toolpath));
        if (first < 0 || end > toolpath.Count || first > end) throw new ArgumentOutOfRangeException(nameof(first));
        var mesh = new ExtrusionMesh();
        var run = new List<(Vec3 Point, double Width, double Height, int Move)>();
        var blobs = new List<(Blob Blob, int Move)>();
        for (var i = first; i < end; i++)
        {
            var move = toolpath[i];
            if (move.Kind != MoveKind.Print || move.Length == 0 || toolpath.BeadOf(move) is not { Area: > 0 } bead)
            {
                if (move.Length > 0) mesh.Close(run);
                else if (Blob.Of(toolpath, move) is { } blob) blobs.Add((blob, i));
                continue;
            }
            // Without a height an extrusion is as high as it is wide.
            var height = bead.Height > 0 ? bead.Height : Math.Sqrt(bead.Area);
            var width = bead.Height > 0 ? bead.Width(BeadShape.Stadium) : height;
            if (run.Count == 0) run.Add((move.Start, width, height, i));
            var chords = move.Arc is { } arc ? arc.ChordCount(move.Start, ArcTolerance) : 1;
            for (var k = 1; k <= chords; k++)
                run.Add((move.PointAt((double)k / chords), width, height, i));
        }
        mesh.Close(run);
        foreach (var (blob, move) in blobs) mesh.Add(blob, move);
        return mesh;
    }

    // The section turned about the vertical, in eight sides.
    private void Add(in Blob blob, int move)
    {
        var n = Section.Length;
        for (var level = n / 2 - 1; level >= 0; level--)
        {
            var (radius, down) = (-Section[level].Side * blob.Width / 2, Section[level].Down * blob.Height);
            for (var k = 0; k < n; k++)
            {
                var (sin, cos) = Angle.SinCos(360.0 * k / n);
                _vertices.Add(blob.Tip + new Vec3(radius * cos, radius * sin, -down));
                _moves.Add(move);
            }
            if (level < n / 2 - 1) AddSides(_vertices.Count - 2 * n);
            if (level == n / 2 - 1) AddCap(_vertices.Count - n, true);
            if (level == 0) AddCap(_vertices.Count - n, false);
        }
    }

    private void Close(List<(Vec3 Point, double Width, double Height, int Move)> run)
    {
        for (var i = 1; i < run.Count; i++)
        {
            var direction = Flat(run[i].Point - run[i - 1].Point);
            var starts = i == 1 || Sharp(run, i - 1);
            if (starts)
            {
                AddRing(run[i - 1].Point, Side(direction), 1, run[i]);
                AddCap(_vertices.Count - Section.Length, true);
            }
            var ends = i == run.Count - 1 || Sharp(run, i);
            var next = ends ? direction : Flat(run[i + 1].Point - run[i].Point);
            var middle = (direction + next).Length > 0 ? Flat(direction + next) : direction;
            AddRing(run[i].Point, Side(middle), 1 / Math.Max(Vec3.Dot(middle, direction), LeastCosine), run[i]);
            AddSides(_vertices.Count - 2 * Section.Length);
            if (ends) AddCap(_vertices.Count - Section.Length, false);
        }
        run.Clear();
    }

    private static bool Sharp(List<(Vec3 Point, double Width, double Height, int Move)> run, int at)
        => Vec3.Dot(Flat(run[at].Point - run[at - 1].Point), Flat(run[at + 1].Point - run[at].Point)) < LeastCosine;

    // Straight up and down there is no side: that of X does.
    private static Vec3 Flat(Vec3 v) => v.LengthXY is > 0 and var length ? new Vec3(v.X / length, v.Y / length, 0) : new Vec3(1, 0, 0);

    private static Vec3 Side(Vec3 direction) => new(-direction.Y, direction.X, 0);

    private void AddRing(Vec3 top, Vec3 side, double stretch, (Vec3 Point, double Width, double Height, int Move) of)
    {
        foreach (var (across, down) in Section)
        {
            _vertices.Add(top + side * (across * stretch * of.Width / 2) - new Vec3(0, 0, down * of.Height));
            _moves.Add(of.Move);
        }
    }

    private void AddSides(int from)
    {
        var n = Section.Length;
        for (var k = 0; k < n; k++)
        {
            var next = (k + 1) % n;
            _quads.AddRange([from + k, from + next, from + n + next, from + n + k]);
        }
    }

    private void AddCap(int from, bool start)
    {
        for (var k = 0; k < 3; k++)
        {
            int a = from + k, b = from + k + 1, c = from + 6 - k, d = from + 7 - k;
            _quads.AddRange(start ? [a, d, c, b] : [a, b, c, d]);
        }
    }
}
