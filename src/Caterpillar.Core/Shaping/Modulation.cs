namespace Caterpillar.Shaping;

/// <summary>Property that a modulation changes.</summary>
public enum ModulationMode
{
    /// <summary>
    /// Print speed at a constant volumetric flow: slower extrusions are thicker. This is Kanada's method, because axes respond faster than extruders.
    /// </summary>
    Speed,

    /// <summary>Area of the bead at a constant speed.</summary>
    Flow,

    /// <summary>Position of the path, displaced horizontally to its left.</summary>
    DisplaceLeft,

    /// <summary>Position of the path, displaced upward.</summary>
    DisplaceUp,
}

/// <summary>
/// Modulates the speed, flow or position of paths by a field such as an image or a function (Kanada 2016, section 3.5: <c>modulate_cylinder</c>, here for
/// any path).
/// </summary>
/// <param name="Mode">Property that is modulated.</param>
/// <param name="Field">Field, from 0 (low) to 1 (high).</param>
/// <param name="Low">Factor of speed or area, or displacement in mm, where the field is 0.</param>
/// <param name="High">Factor of speed or area, or displacement in mm, where the field is 1.</param>
public sealed record Modulation(ModulationMode Mode, Field Field, double Low, double High)
{
    /// <summary>Minimum ratio of speeds or areas that prints well (Kanada 2016: 0.6 or 0.7 to 1).</summary>
    public const double MinRatio = 0.6;

    /// <summary>Strength of the modulation at each point, 0 to 1. Null = full strength everywhere.</summary>
    public Field? Mask { get; init; }

    /// <summary>Maximum length of the parts into which segments are first divided, mm. 0 = not divided.</summary>
    public double Resolution { get; init; }

    /// <summary>Speed in mm/s of beads without their own speed. Only <see cref="ModulationMode.Speed"/> uses it.</summary>
    public double ReferenceSpeed { get; init; }

    /// <summary>Modulates paths, each along its own length.</summary>
    /// <returns>The paths in the same order, or an error. A warning if the ratio of the minimum to the maximum factor is below
    /// <see cref="MinRatio"/>.</returns>
    public Result<IReadOnlyList<PrintPath>> Apply(IReadOnlyList<PrintPath> paths, IProgress<double>? progress = null, CancellationToken cancel = default)
    {
        if (paths is null) throw new ArgumentNullException(nameof(paths));
        var problems = new DiagnosticList();
        var modulated = new List<PrintPath>(paths.Count);
        double least = double.MaxValue, greatest = 0;
        if (Resolution > 0 && !(paths.Sum(p => p.Length) / Resolution <= PathDivision.MaxSegments))
        {
            return new Result<IReadOnlyList<PrintPath>>("shape.too_fine",
                $"The paths would have more than {NumberFormatter.Format(PathDivision.MaxSegments)} segments in total. Use a coarser resolution.");
        }
        for (var i = 0; i < paths.Count; i++)
        {
            cancel.ThrowIfCancellationRequested();
            var path = Mode is ModulationMode.Speed or ModulationMode.Flow
                ? Scale(paths[i], i, problems, ref least, ref greatest, cancel)
                : Displace(paths[i], i, problems, cancel);
            if (path is not null) modulated.Add(path);
            progress?.Report((i + 1.0) / paths.Count);
        }
        if (greatest > 0 && least < MinRatio * greatest * (1 - 1e-12))
        {
            problems.Add(Severity.Warning, "shape.modulation_ratio",
                $"The extrusions vary by a ratio of 1 to {NumberFormatter.Format(least / greatest, 2)}. "
                + $"Prints often fail below 1 to {NumberFormatter.Format(MinRatio, 2)}.");
        }
        return new Result<IReadOnlyList<PrintPath>>(problems.HasErrors ? null : modulated, problems.ToList());
    }

    private PrintPath? Scale(PrintPath path, int number, DiagnosticList problems, ref double least, ref double greatest, CancellationToken cancel)
    {
        var (points, beads, closed, arcs) = Parts(path, cancel);
        var places = new PathSamples(points, path, number, closed);
        for (var i = 0; i < beads.Length; i++)
        {
            if ((i & 0xFFF) == 0) cancel.ThrowIfCancellationRequested();
            var change = ValueAt(places.Middle(i), 1, number, problems);
            if (change is not { } factor) return null;
            if (!(factor > 0 || (factor == 0 && Mode == ModulationMode.Flow)))
            {
                problems.Add(Severity.Error, "shape.modulation", "A modulated speed or area must stay positive.", new SourceLocation(Step: number));
                return null;
            }
            least = Math.Min(least, factor);
            greatest = Math.Max(greatest, factor);
            if (Mode == ModulationMode.Flow)
            {
                beads[i] = beads[i] with { Area = beads[i].Area * factor };
                continue;
            }
            var speed = beads[i].Speed > 0 ? beads[i].Speed : ReferenceSpeed;
            if (!(speed > 0))
            {
                problems.Add(Severity.Error, "shape.no_speed", "The path has no speed of its own. Set a reference speed to modulate it.",
                    new SourceLocation(Step: number));
                return null;
            }
            beads[i] = new Bead(beads[i].Area / factor, beads[i].Height, speed * factor);
        }
        return path.WithGeometry(points, beads, closed, arcs);
    }

    private PrintPath? Displace(PrintPath path, int number, DiagnosticList problems, CancellationToken cancel)
    {
        var (points, beads, closed) = PathDivision.Straight(path, Resolution, cancel);
        var places = new PathSamples(points, path, number, closed);
        var moved = new Vec3[points.Length];
        for (var i = 0; i < points.Length; i++)
        {
            if ((i & 0xFFF) == 0) cancel.ThrowIfCancellationRequested();
            if (ValueAt(places.Vertex(i), 0, number, problems) is not { } amount) return null;
            moved[i] = points[i] + (Mode == ModulationMode.DisplaceUp ? Vec3.UnitZ : places.Left(i)) * amount;
        }
        return path.WithGeometry(moved, beads, closed);
    }

    private (Vec3[] Points, Bead[] Beads, bool Closed, Arc?[]? Arcs) Parts(PrintPath path, CancellationToken cancel)
    {
        if (Resolution > 0)
        {
            var (points, beads, closed) = PathDivision.Straight(path, Resolution, cancel);
            return (points, beads, closed, null);
        }
        var segments = Enumerable.Range(0, path.SegmentCount);
        return ((Vec3[])path.RawPoints.Clone(), [.. segments.Select(path.BeadOf)], path.IsClosed, path.HasArcs ? [.. segments.Select(path.ArcOf)] : null);
    }

    private double? ValueAt(PathSample place, double neutral, int number, DiagnosticList problems)
    {
        var value = Field(place);
        var weight = Mask?.Invoke(place) ?? 1;
        if (double.IsNaN(value) || double.IsNaN(weight))
        {
            problems.Add(Severity.Error, "shape.field", "The field or its mask has no value on the path.", new SourceLocation(Step: number));
            return null;
        }
        value = Math.Max(0, Math.Min(1, value));
        weight = Math.Max(0, Math.Min(1, weight));
        return neutral + (Low + (High - Low) * value - neutral) * weight;
    }
}
