namespace Caterpillar.Shaping;

/// <summary>Deforms planned or decoded toolpaths.</summary>
public static class ToolpathDeformation
{
    /// <summary>
    /// Deforms the selected extrusions and the selected moves between them. The rest stays, and travels lead to the new starts of extrusions. Extrusions are
    /// divided until they match their image within the tolerance, and arcs become chords. The material of an extrusion follows its length and the area map,
    /// whose unit is mm² if the toolpath has a filament diameter, otherwise E per mm. The speed map applies to extrusions only.
    /// </summary>
    /// <param name="toolpath">The toolpath.</param>
    /// <param name="filter">Selected moves.</param>
    /// <param name="deformation">The deformation.</param>
    /// <param name="tolerance">Tolerance in mm, above 0.</param>
    /// <param name="cancel">Cancels.</param>
    /// <returns>The toolpath, or an error if a map gives a value that is not finite or, for areas and speeds, negative.</returns>
    /// <exception cref="ArgumentOutOfRangeException">The tolerance is not positive.</exception>
    public static Result<Toolpath> Deform(
        this Toolpath toolpath, MoveFilter filter, Deformation deformation, double tolerance = 0.01, CancellationToken cancel = default)
    {
        if (toolpath is null) throw new ArgumentNullException(nameof(toolpath));
        if (filter is null) throw new ArgumentNullException(nameof(filter));
        if (deformation is null) throw new ArgumentNullException(nameof(deformation));
        if (!(tolerance > 0) || double.IsInfinity(tolerance))
            throw new ArgumentOutOfRangeException(nameof(tolerance), tolerance, "The tolerance must be positive.");
        var map = new DeformationRunMap(deformation, tolerance);
        var mapped = new ToolpathMapper(toolpath, MappedMoves.Of(toolpath, filter), map, tolerance).Run(toolpath.Start ?? Vec3.Zero, cancel);
        return map.Problem is { } problem ? new Result<Toolpath>(null, [problem]) : new Result<Toolpath>(mapped, []);
    }

    private sealed class DeformationRunMap(Deformation deformation, double tolerance) : RunMap
    {
        private readonly Func<Vec3[], Vec3[]> _map = deformation.Map;

        public Diagnostic? Problem { get; private set; }

        public override void Divide(Move move, MoveRun run) => DivideSmoothly(move, run, tolerance, _map);

        public override void Map(MoveRun run)
        {
            var points = run.Points.ToArray();
            var areas = new double[run.Moves.Count];
            var speeds = run.Speeds.ToArray();
            for (var i = 0; i < areas.Length; i++)
            {
                var move = run.Toolpath[run.Moves[i]];
                areas[i] = move.Kind == MoveKind.Print && move.Length > 0 ? move.Deposited / move.Length * (run.Toolpath.VolumePerE(move.Tool) ?? 1) : 0;
            }
            var before = areas.ToArray();
            if (deformation.Run(ref points, areas, speeds, default) is { } problem)
            {
                var first = run.Toolpath[run.Moves[0]];
                Problem ??= problem with { Source = run.Toolpath.Source == MoveSource.Lines ? new SourceLocation(Line: first.Source)
                    : new SourceLocation(Move: first.Index) };
                return;
            }
            for (var i = 0; i < points.Length; i++) run.Points[i] = points[i];
            for (var i = 0; i < areas.Length; i++)
            {
                if (before[i] <= 0) continue;
                run.Flows[i] = areas[i] / before[i];
                run.Speeds[i] = speeds[i];
            }
        }
    }
}
