using Caterpillar.Geometry;

namespace Caterpillar.Toolpaths;

/// <summary>A coordinate of a path.</summary>
public enum PathAxis : byte
{
    X,
    Y,
    Z,
}

/// <summary>The G-code word that a coordinate is mapped to: a rotary axis, or a linear axis with another use.</summary>
public enum OutputAxis : byte
{
    A,
    B,
    C,
    X,
    Y,
    Z,
}

/// <summary>
/// Maps a coordinate of the path to another word, scaled, for printers with a rotating platform or other extra axes (Caterpillar 2019, section 6: a sleeve
/// motor that turns the platform, "generated based on the scaled toolpaths"). The path is planned unrolled and mapped last. E and the time of every move do
/// not change.
/// </summary>
/// <param name="From">The source coordinate.</param>
/// <param name="To">The target word.</param>
/// <param name="Scale">Degrees (rotary word) or mm (linear word) per mm of the coordinate. May be negative.</param>
/// <param name="Hold">Constant value of the source coordinate if another word replaces it, mm.</param>
public sealed record AxisMapping(PathAxis From, OutputAxis To, double Scale, double Hold = 0)
{
    private const double ChordTolerance = 0.01;

    /// <summary>The mapping for a drum with a diameter in mm. One circumference is one turn.</summary>
    public static AxisMapping Drum(PathAxis from, OutputAxis to, double diameter, double hold = 0)
        => diameter > 0 ? new AxisMapping(from, to, 360 / (Math.PI * diameter), hold)
            : throw new ArgumentOutOfRangeException(nameof(diameter), "The diameter of a drum must be positive.");

    /// <summary>
    /// The mapped toolpath. Arcs become chords. The speed of each move is adjusted to keep its time. It is measured along X, Y and Z if one of them moves,
    /// otherwise in degrees per second (as in RS274/NGC section 2.1.2.5).
    /// </summary>
    /// <exception cref="InvalidOperationException">The scale is zero or not finite, or two coordinates would map to one word.</exception>
    public Toolpath Apply(Toolpath toolpath, IProgress<double>? progress = null, CancellationToken cancel = default)
    {
        if (toolpath is null) throw new ArgumentNullException(nameof(toolpath));
        if (Scale == 0 || double.IsNaN(Scale - Scale)
            || double.IsNaN(Hold - Hold))
        {
            throw new InvalidOperationException("The scale of an axis must be finite and not zero.");
        }
        if (To >= OutputAxis.X && To - OutputAxis.X != (int)From)
            throw new InvalidOperationException("A linear word can only be mapped from its own coordinate.");
        var builder = new ToolpathBuilder(toolpath.Source, toolpath.Start is { } start ? Mapped(start) : null);
        foreach (var layer in toolpath.Layers) builder.AddLayer(layer);
        var nextEvent = 0;
        var turn = 0.0;
        foreach (var move in toolpath.Moves())
        {
            if ((move.Index & 0xFFFF) == 0)
            {
                cancel.ThrowIfCancellationRequested();
                progress?.Report((double)move.Index / toolpath.Count);
            }
            for (; nextEvent < toolpath.Events.Count
                && toolpath.Events[nextEvent].Move <= move.Index; nextEvent++) builder.AddEvent(toolpath.Events[nextEvent].Event);
            var parts = move.Arc is { } arc ? arc.ChordCount(move.Start, ChordTolerance) : 1;
            var last = move.Start;
            for (var k = 1; k <= parts; k++)
            {
                var next = move.Arc is { } curve ? curve.PointAt(move.Start, move.End, (double)k / parts) : move.End;
                var (from, to) = (Mapped(last), Mapped(next));
                var newTurn = To < OutputAxis.X ? Coordinate(next) * Scale : 0;
                builder.Add(to, move.E / parts, move.Deposited / parts, Speed(move, last, next, from, to, newTurn - turn), move.Kind, move.Role, move.Layer,
                    move.Tool, move.Source);
                turn = newTurn;
                if (To < OutputAxis.X) builder.SetRotary(To == OutputAxis.A ? turn : 0, To == OutputAxis.B ? turn : 0, To == OutputAxis.C ? turn : 0);
                last = next;
            }
        }
        for (; nextEvent < toolpath.Events.Count; nextEvent++) builder.AddEvent(toolpath.Events[nextEvent].Event);
        return builder.Build(toolpath.Tools);
    }

    private static double Speed(Move move, Vec3 last, Vec3 next, Vec3 from, Vec3 to, double degrees)
    {
        var length = last.DistanceTo(next);
        if (!(length > 0)) return move.Speed;
        var distance = from.DistanceTo(to);
        return move.Speed * (distance > 0 ? distance : Math.Abs(degrees)) / length;
    }

    private double Coordinate(Vec3 p) => From switch { PathAxis.X => p.X, PathAxis.Y => p.Y, _ => p.Z };

    private Vec3 Mapped(Vec3 p)
    {
        var value = To < OutputAxis.X ? Hold : Coordinate(p) * Scale;
        return From switch
        {
            PathAxis.X => new Vec3(value, p.Y, p.Z),
            PathAxis.Y => new Vec3(p.X, value, p.Z),
            _ => new Vec3(p.X, p.Y, value),
        };
    }
}
