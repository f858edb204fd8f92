namespace Caterpillar.Toolpaths;

/// <summary>Steps as compressed bytes, for files that hold designs. Nothing of a step is lost.</summary>
public static class StepBytes
{
    /// <summary>The step as bytes.</summary>
    public static byte[] Pack(Step step)
    {
        if (step is null) throw new ArgumentNullException(nameof(step));
        return Packed.Pack(w =>
        {
            w.WriteRecord(step.Source);
            switch (step)
            {
                case PathStep path:
                    w.Write('p');
                    Write(w, path);
                    break;
                case TravelStep travel:
                    w.Write('t');
                    w.WriteList(travel.Points, w.Write);
                    w.Write(travel.Speed);
                    w.Write((byte)travel.Intent);
                    break;
                case EventStep what:
                    w.Write('e');
                    w.WriteEvent(what.Event);
                    break;
            }
        });
    }

    /// <summary>The step in bytes. Null if they are damaged or of a later version.</summary>
    public static Step? Unpack(byte[] bytes) => Packed.Unpack<Step>(bytes, r =>
    {
        var source = r.ReadRecord<SourceLocation>();
        return r.ReadChar() switch
        {
            'p' => ReadPath(r, source),
            't' => new TravelStep(r.ReadList(r.ReadPoint), r.ReadDouble(), (TravelIntent)r.ReadByte()) { Source = source },
            'e' => new EventStep(r.ReadEvent()) { Source = source },
            _ => throw new InvalidDataException(),
        };
    });

    private static void Write(BinaryWriter w, PathStep step)
    {
        var path = step.Path;
        w.WriteRecord(new Properties(path.IsClosed, path.Role, path.Layer, path.Tool, path.Name, path.Color, path.Overrides, step.Group, step.KeepStart,
            step.Joined, step.GoesOn, step.Lines));
        w.WriteList(path.Points, w.Write);
        w.WriteList(Enumerable.Range(0, path.IsUniform ? 1 : path.SegmentCount).ToArray(), i =>
        {
            w.Write(path.BeadOf(i).Area);
            w.Write(path.BeadOf(i).Height);
            w.Write(path.BeadOf(i).Speed);
        });
        w.WriteList(Enumerable.Range(0, path.HasArcs ? path.SegmentCount : 0).ToArray(), i =>
        {
            w.Write(path.ArcOf(i) is not null);
            if (path.ArcOf(i) is { } arc) w.Write(arc);
        });
        w.Write(step.Region is not null);
        w.WriteList(step.Region?.Paths ?? [], contour => w.WriteList(contour, point =>
        {
            w.Write(point.X);
            w.Write(point.Y);
        }));
    }

    private static PathStep ReadPath(BinaryReader r, SourceLocation? source)
    {
        var p = r.ReadRecord<Properties>() ?? throw new InvalidDataException();
        var points = r.ReadList(r.ReadPoint);
        var beads = r.ReadList(() => new Bead(r.ReadDouble(), r.ReadDouble(), r.ReadDouble()));
        var arcs = r.ReadList(() => r.ReadBoolean() ? r.ReadArc() : (Arc?)null);
        var hasRegion = r.ReadBoolean();
        var contours = r.ReadList(() => r.ReadList(() => new GridPoint(r.ReadInt32(), r.ReadInt32())).ToArray()).ToArray();
        var segments = p.Closed ? points.Count : points.Count - 1;
        if (beads.Count == 1) beads = Enumerable.Repeat(beads[0], Math.Max(segments, 0)).ToList();
        var path = new PrintPath(points, beads, p.Closed, arcs.Count > 0 ? arcs : null)
        {
            Role = p.Role, Layer = p.Layer, Tool = p.Tool, Name = p.Name, Color = p.Color, Overrides = p.Overrides,
        };
        return new PathStep(path, p.Group)
        {
            KeepStart = p.KeepStart, Joined = p.Joined, GoesOn = p.GoesOn, Lines = p.Lines, Source = source,
            Region = hasRegion ? Region.Own(contours) : null,
        };
    }

    private sealed record Properties(
        bool Closed, Role Role, Layer? Layer, int Tool, string Name, int? Color, PathOverrides? Overrides, StepGroup? Group, bool KeepStart, bool Joined,
        bool GoesOn, int[]? Lines);
}
