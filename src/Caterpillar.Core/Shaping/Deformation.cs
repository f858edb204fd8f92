namespace Caterpillar.Shaping;

/// <summary>Maps a position in mm. In cylindrical deformations, X is the radius in mm, Y the angle in degrees and Z the height in mm.</summary>
public delegate Vec3 PositionMap(Vec3 position);

/// <summary>Maps a value (area in mm² or speed in mm/s) at a position, in coordinates before the position map.</summary>
public delegate double ValueMap(double value, Vec3 position);

/// <summary>
/// Deforms print paths by maps of position, area and speed (Kanada 2016, section 3.4: <c>deform_xyz</c>, <c>deform_cylinder</c>). Position maps apply to the
/// ends of segments. Area and speed maps give one value per segment, at its midpoint before the position map. Combine deformations with
/// <see cref="Then"/>. E follows from the mapped length.
/// </summary>
public sealed class Deformation
{
    // mm; no printer reaches farther, and numbers of G-code keep their decimals.
    private const double Farthest = 1e6;

    // mm² and mm/s.
    private const double Largest = 1e6;

    private readonly Stage[] _stages;

    private Deformation(Stage[] stages) => _stages = stages;

    /// <summary>A deformation of x, y, z in mm.</summary>
    public static Deformation Cartesian(PositionMap? position = null, ValueMap? area = null, ValueMap? speed = null)
        => new([new Stage(position, area, speed, null)]);

    /// <summary>
    /// A deformation of radius (mm), angle (degrees) and height (mm) about the vertical through <paramref name="axis"/>. Along a path the angle continues
    /// through full turns. On the axis it keeps its last value.
    /// </summary>
    public static Deformation Cylindrical(PositionMap? position = null, ValueMap? area = null, ValueMap? speed = null, Vec3 axis = default)
        => new([new Stage(position, area, speed, axis.WithZ(0))]);

    /// <summary>This deformation followed by another.</summary>
    public Deformation Then(Deformation next)
    {
        if (next is null) throw new ArgumentNullException(nameof(next));
        return new Deformation([.. _stages, .. next._stages]);
    }

    /// <summary>
    /// Deforms paths. With a tolerance (mm), segments are first divided until they match the mapped line or arc within it, so that curves stay smooth. With a
    /// tolerance of 0, every segment stays one straight segment. Arcs become chords.
    /// </summary>
    /// <returns>The paths in the same order, or an error if a map gives a position that is not finite, or an area or speed that is negative or not
    /// finite.</returns>
    /// <exception cref="ArgumentOutOfRangeException">The tolerance is negative.</exception>
    public Result<IReadOnlyList<PrintPath>> Apply(
        IReadOnlyList<PrintPath> paths, double tolerance = 0, IProgress<double>? progress = null, CancellationToken cancel = default)
    {
        if (paths is null) throw new ArgumentNullException(nameof(paths));
        if (!(tolerance >= 0)) throw new ArgumentOutOfRangeException(nameof(tolerance), "The tolerance must not be negative.");
        var problems = new DiagnosticList();
        var mapped = new List<PrintPath>(paths.Count);
        var segments = 0L;
        for (var i = 0; i < paths.Count; i++)
        {
            cancel.ThrowIfCancellationRequested();
            var path = Apply(paths[i], tolerance, i, problems, cancel);
            progress?.Report((i + 1.0) / paths.Count);
            if (path is null) continue;
            mapped.Add(path);
            segments += path.SegmentCount;
            if (segments <= PathDivision.MaxSegments) continue;
            problems.Add(Severity.Error, "shape.too_fine",
                $"The paths would have more than {NumberFormatter.Format(PathDivision.MaxSegments)} segments in total. Increase the tolerance.");
            break;
        }
        return new Result<IReadOnlyList<PrintPath>>(problems.HasErrors ? null : mapped, problems.ToList());
    }

    private PrintPath? Apply(PrintPath path, double tolerance, int number, DiagnosticList problems, CancellationToken cancel)
    {
        var divided = PathDivision.Divide(path, tolerance, this, cancel);
        var points = divided.Points;
        var values = divided.Beads;
        var areas = Array.ConvertAll(values, v => v.Area);
        var speeds = Array.ConvertAll(values, v => v.Speed);
        if (Run(ref points, areas, speeds, cancel) is { } problem)
        {
            problems.Add(problem with { Source = new SourceLocation(Step: number) });
            return null;
        }
        for (var i = 0; i < values.Length; i++) values[i] = new Bead(areas[i], values[i].Height, speeds[i]);
        if (!path.IsClosed) return path.WithGeometry(points, values, false);
        // A closed path stays closed where its ends still meet: a map of the angle may open it.
        var last = points.Length - 1;
        if (points[last].DistanceTo(points[0]) > 1e-6) return path.WithGeometry(points, values, false);
        Array.Resize(ref points, last);
        return path.WithGeometry(points, values, true);
    }

    /// <summary>
    /// Maps a run of points, and the areas (mm²) and speeds (mm/s) of the segments between them; returns the error of a map, after which the results are
    /// useless.
    /// </summary>
    internal Diagnostic? Run(ref Vec3[] points, double[] areas, double[] speeds, CancellationToken cancel)
    {
        foreach (var stage in _stages)
        {
            var before = stage.Coordinates(points);
            for (var i = 0; i < areas.Length; i++)
            {
                if ((i & 0xFFF) == 0) cancel.ThrowIfCancellationRequested();
                var middle = (before[i] + before[i + 1]) * 0.5;
                areas[i] = stage.Area?.Invoke(areas[i], middle) ?? areas[i];
                speeds[i] = stage.Speed?.Invoke(speeds[i], middle) ?? speeds[i];
                if (!(areas[i] is >= 0 and <= Largest) || !(speeds[i] is >= 0 and <= Largest))
                    return new Diagnostic(Severity.Error, "shape.value",
                        "The area or speed map gives a value that is negative, not finite or above a million.");
            }
            points = Array.ConvertAll(before, stage.Map);
            foreach (var point in points)
            {
                if (!point.IsFinite) return new Diagnostic(Severity.Error, "shape.position", "The position map gives a point that is not finite.");
                if (Math.Abs(point.X) > Farthest || Math.Abs(point.Y) > Farthest || Math.Abs(point.Z) > Farthest)
                    return new Diagnostic(Severity.Error, "shape.position", "The position map gives a point more than a kilometer from the origin.");
            }
        }
        return null;
    }

    /// <summary>Maps a run of points through all stages; angles continue from point to point.</summary>
    internal Vec3[] Map(Vec3[] points)
    {
        foreach (var stage in _stages) points = Array.ConvertAll(stage.Coordinates(points), stage.Map);
        return points;
    }

    private sealed class Stage(PositionMap? position, ValueMap? area, ValueMap? speed, Vec3? axis)
    {
        public ValueMap? Area => area;

        public ValueMap? Speed => speed;

        public Vec3[] Coordinates(Vec3[] points)
        {
            if (axis is not { } a) return points;
            var result = new Vec3[points.Length];
            var last = double.NaN;
            for (var i = 0; i < points.Length; i++)
            {
                var d = points[i] - a;
                var radius = d.LengthXY;
                var angle = Angle.Atan2(d.Y, d.X);
                if (!double.IsNaN(last)) angle = radius > 0 ? angle + 360 * Math.Floor((last - angle) / 360 + 0.5) : last;
                if (radius > 0) last = angle;
                else if (double.IsNaN(last)) angle = FirstAngle(points, i, a);
                result[i] = new Vec3(radius, angle, points[i].Z);
            }
            return result;
        }

        public Vec3 Map(Vec3 coordinates)
        {
            var mapped = position is null ? coordinates : position(coordinates);
            if (axis is not { } a) return mapped;
            var (sin, cos) = Angle.SinCos(mapped.Y);
            return new Vec3(a.X + mapped.X * cos, a.Y + mapped.X * sin, mapped.Z);
        }

        // A path that begins on the axis takes the angle of its first point off it.
        private static double FirstAngle(Vec3[] points, int from, Vec3 axis)
        {
            for (var i = from + 1; i < points.Length; i++)
            {
                var d = points[i] - axis;
                if (d.LengthXY > 0) return Angle.Atan2(d.Y, d.X);
            }
            return 0;
        }
    }
}
