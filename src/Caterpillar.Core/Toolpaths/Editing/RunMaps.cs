namespace Caterpillar.Toolpaths;

/// <summary>Moves, rotates and scales. Arcs stay arcs if circles stay circles.</summary>
internal sealed class AffineRunMap(Affine map, double tolerance) : RunMap
{
    private readonly bool _keepsArcs = Mapping.KeepsCircles(map);
    private readonly bool _scales = !Mapping.KeepsLengths(map);
    private readonly bool _lifts = map.XAxis.Z != 0 || map.YAxis.Z != 0 || map.ZAxis.Z != 1 || map.Shift.Z != 0;
    private readonly double _volume = Math.Abs(map.Determinant);

    public override bool IsLocal => true;

    public override void Divide(Move move, MoveRun run)
    {
        var chords = move.Arc is { } arc && !_keepsArcs ? arc.ChordCount(move.Start, move.End, tolerance) : 1;
        for (var k = 1; k <= chords; k++)
        {
            run.Points.Add(move.PointAt((double)k / chords));
            run.Shares.Add(1.0 / chords);
        }
        run.Close(move, _keepsArcs ? move.Arc : null);
    }

    public override void Map(MoveRun run)
    {
        var from = run.Points[0];
        run.Points[0] = map.Apply(from);
        for (var i = 0; i < run.Arcs.Count; i++)
        {
            var (start, to) = (from, run.Points[i + 1]);
            run.Points[i + 1] = map.Apply(to);
            from = to;
            var length = run.Arcs[i] is { } arc ? arc.Length(start, to) : start.DistanceTo(to);
            if (run.Arcs[i] is { } before) run.Arcs[i] = Mapping.Image(before, map);
            if (!_scales || !(length > 0)) continue;
            // An extrusion is scaled as a solid: its volume by the determinant, so its area by that and by how much shorter it gets.
            var image = run.Arcs[i] is { } after ? after.Length(run.Points[i], run.Points[i + 1]) : run.Points[i].DistanceTo(run.Points[i + 1]);
            if (image > 0) run.Flows[i] = _volume * length / image;
        }
    }

    // The same for straight moves, column by column. Where lengths stay, amounts do.
    public override ToolpathColumns? MapBlock(ToolpathColumns block, Vec3 start, Vec3 position)
    {
        if (block.Arcs.Length > 0 || block.Turns is not null) return null;
        var from = map.Apply(start);
        var newAmounts = _scales || position != from;
        var image = block.WithGeometry(_lifts, newAmounts);
        for (var i = 0; i < block.Count; i++)
        {
            var end = new Vec3(block.X[i], block.Y[i], block.Z[i]);
            var to = map.Apply(end);
            (image.X[i], image.Y[i]) = (to.X, to.Y);
            if (_lifts) image.Z[i] = to.Z;
            if (!newAmounts) continue;
            var deposited = block.Deposited[i];
            if (block.Kind[i] == MoveKind.Print && start.DistanceTo(end) is > 0 and var length)
            {
                var flow = _scales && from.DistanceTo(to) is > 0 and var mapped ? _volume * length / mapped : 1;
                deposited = deposited / length * flow * position.DistanceTo(to);
            }
            image.E[i] = deposited + (block.E[i] - block.Deposited[i]);
            image.Deposited[i] = deposited;
            (start, from, position) = (end, to, to);
        }
        return image;
    }
}
