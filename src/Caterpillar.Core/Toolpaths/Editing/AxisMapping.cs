namespace Caterpillar.Toolpaths;

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
/// motor that turns the platform, "generated based on the scaled toolpaths"). Toolpaths are those of the unrolled surface: they are mapped where a file is
/// written, and unrolled where it is read. E and the time of every move do not change.
/// </summary>
/// <param name="From">The source coordinate.</param>
/// <param name="To">The target word.</param>
/// <param name="Scale">Degrees (rotary word) or mm (linear word) per mm of the coordinate. May be negative.</param>
/// <param name="Hold">Constant value of the source coordinate if another word replaces it, mm.</param>
public sealed record AxisMapping(PathAxis From, OutputAxis To, double Scale, double Hold = 0)
{
    /// <summary>Reads <c>X=A*2.86</c> or <c>X=A*2.86@110</c>, where X is held at 110 mm. Null if the text is invalid.</summary>
    public static AxisMapping? Parse(string text)
    {
        if (text is null) throw new ArgumentNullException(nameof(text));
        int equals = text.IndexOf('=', 0), star = text.IndexOf('*', 0), at = text.IndexOf('@', 0);
        if (equals != 1 || star != 3) return null;
        int from = "XYZ".IndexOf(char.ToUpperInvariant(text[0]), 0), to = "ABCXYZ".IndexOf(char.ToUpperInvariant(text[2]), 0);
        if (from < 0 || to < 0 || (to >= 3 && to - 3 != from)) return null;
        var hold = 0.0;
        if (at >= 0 && (!NumberReader.TryParse(text.Substring(at + 1), out hold) || to >= 3)) return null;
        return NumberReader.TryParse(text.Substring(4, (at < 0 ? text.Length : at) - 4), out var scale) && scale != 0
            ? new AxisMapping((PathAxis)from, (OutputAxis)to, scale, hold) : null;
    }

    /// <summary>The text that <see cref="Parse"/> reads.</summary>
    public override string ToString()
        => $"{From}={To}*{NumberFormatter.Format(Scale, 8)}{(Hold == 0 ? "" : "@" + NumberFormatter.Format(Hold, 6))}";

    /// <summary>True if a rotary word replaces the coordinate, so that it has no end.</summary>
    internal bool IsRotary => To < OutputAxis.X;

    /// <summary>
    /// The toolpath of the unrolled surface from one that was read with mapped axes: each coordinate is what the head moves over the surface, by its own axis
    /// and by the turn of the platform. Moves that only turn the platform print or travel like others.
    /// </summary>
    internal static Toolpath Unroll(Toolpath toolpath, IReadOnlyList<AxisMapping> mappings, CancellationToken cancel = default)
        => mappings.Count == 0 ? toolpath : RotaryColumns.Mapped(toolpath, (p, turns) => Unrolled(p, turns, mappings), keepsTurns: false, cancel);

    /// <summary>Where the head of the machine is for a point of the surface. A coordinate that a rotary word replaces is held.</summary>
    internal static Vec3 Head(Vec3 p, IReadOnlyList<AxisMapping> mappings)
    {
        foreach (var mapping in mappings) p = mapping.Mapped(p);
        return p;
    }

    /// <summary>
    /// The mapped toolpath. Arcs become chords. The speed of each move is adjusted to keep its time. It is measured along X, Y and Z if one of them moves,
    /// otherwise in degrees per second (as in RS274/NGC section 2.1.2.5).
    /// </summary>
    /// <exception cref="InvalidOperationException">The scale is zero or not finite, or two coordinates would map to one word.</exception>
    public Toolpath Apply(Toolpath toolpath, IProgress<double>? progress = null, CancellationToken cancel = default)
    {
        if (toolpath is null) throw new ArgumentNullException(nameof(toolpath));
        if (Scale == 0 || double.IsNaN(Scale - Scale) || double.IsNaN(Hold - Hold))
            throw new InvalidOperationException("The scale of an axis must be finite and not zero.");
        if (To >= OutputAxis.X && To - OutputAxis.X != (int)From)
            throw new InvalidOperationException("A linear word can only be mapped from its own coordinate.");
        var turns = toolpath.HasTurns;
        var turn = 0.0;
        return StraightPieces.Rebuilt(toolpath, toolpath.Start is { } start ? Mapped(start) : null, Add, progress, cancel);

        void Add(ToolpathBuilder builder, Move piece)
        {
            var newTurn = IsRotary ? Coordinate(piece.End) * Scale : 0;
            builder.Add(piece with { End = Mapped(piece.End), Speed = Speed(piece, newTurn - turn) });
            turn = newTurn;
            if (!IsRotary && !turns) return;
            var own = toolpath.TurnsOf(piece.Index) ?? default;
            builder.SetRotary(new Vec3(To == OutputAxis.A ? turn : own.X, To == OutputAxis.B ? turn : own.Y, To == OutputAxis.C ? turn : own.Z));
        }
    }

    private static Vec3 Unrolled(Vec3 p, Vec3 turn, IReadOnlyList<AxisMapping> mappings)
    {
        foreach (var mapping in mappings)
        {
            var value = mapping.Coordinate(p);
            p = mapping.With(p, !mapping.IsRotary ? value / mapping.Scale
                : value - mapping.Hold + (mapping.To switch { OutputAxis.A => turn.X, OutputAxis.B => turn.Y, _ => turn.Z }) / mapping.Scale);
        }
        return p;
    }

    private double Speed(in Move piece, double degrees)
    {
        if (!(piece.Length > 0)) return piece.Speed;
        return piece.Speed * RotaryColumns.Share(Mapped(piece.Start).DistanceTo(Mapped(piece.End)), Math.Abs(degrees)) / piece.Length;
    }

    private double Coordinate(Vec3 p) => From switch { PathAxis.X => p.X, PathAxis.Y => p.Y, _ => p.Z };

    private Vec3 Mapped(Vec3 p) => With(p, IsRotary ? Hold : Coordinate(p) * Scale);

    private Vec3 With(Vec3 p, double value) => From switch
    {
        PathAxis.X => new Vec3(value, p.Y, p.Z),
        PathAxis.Y => new Vec3(p.X, value, p.Z),
        _ => new Vec3(p.X, p.Y, value),
    };
}
