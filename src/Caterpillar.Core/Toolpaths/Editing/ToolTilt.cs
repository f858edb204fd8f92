namespace Caterpillar.Toolpaths;

/// <summary>The rotary words with which a machine tilts its tool.</summary>
public enum TiltAxes : byte
{
    /// <summary>B tilts about Y, then C turns about Z: the tool points along (sin B · cos C, sin B · sin C, cos B).</summary>
    BC,

    /// <summary>A tilts about X, then C turns about Z: the tool points along (sin A · sin C, −sin A · cos C, cos A).</summary>
    AC,
}

/// <summary>
/// Tilts the tool along the normals of a surface: every move ends with rotary words in degrees. X, Y and Z stay the position of the nozzle tip. The controller
/// moves the joints (tool center point control: G43.4, RTCP, TRAORI).
/// </summary>
/// <param name="Axes">The words.</param>
/// <param name="MaxTilt">Maximum tilt from vertical, degrees, above 0 and at most 90. Steeper normals are limited to it.</param>
public sealed record ToolTilt(TiltAxes Axes, double MaxTilt = 90)
{
    // Degrees: where the tool is as good as upright its azimuth says nothing.
    private const double Upright = 0.05;

    /// <summary>
    /// The words that tilt the tool of a toolpath: A and C, or B and C. Null if it has no rotary words, or turns both A and B (another kind of machine).
    /// </summary>
    public static TiltAxes? AxesOf(Toolpath toolpath)
    {
        if (toolpath is null) throw new ArgumentNullException(nameof(toolpath));
        var (hasA, hasB) = (false, false);
        foreach (var block in toolpath.Blocks)
        {
            hasA |= Turns(block.Columns.A);
            hasB |= Turns(block.Columns.B);
        }
        return !toolpath.HasTurns || (hasA && hasB) ? null : hasA ? TiltAxes.AC : TiltAxes.BC;
    }

    /// <summary>The unit vector from the nozzle tip along the tool, for rotary words in degrees.</summary>
    public static Vec3 Direction(TiltAxes axes, (double A, double B, double C) turns)
    {
        var (sin, cos) = Angle.SinCos(axes == TiltAxes.BC ? turns.B : turns.A);
        var (sinC, cosC) = Angle.SinCos(turns.C);
        return axes == TiltAxes.BC ? new Vec3(sin * cosC, sin * sinC, cos) : new Vec3(sin * sinC, -sin * cosC, cos);
    }

    /// <summary>The tilt for a normal, and the turn nearest to the previous turn, degrees.</summary>
    /// <param name="normal">Upward, of any length.</param>
    /// <param name="lastTurn">The previous turn of C, degrees.</param>
    public (double Tilt, double Turn) Angles(Vec3 normal, double lastTurn = 0)
    {
        if (!(MaxTilt > 0 && MaxTilt <= 90)) throw new InvalidOperationException("The maximum tilt must be above 0 and at most 90 degrees.");
        var tilt = Math.Min(MaxTilt, Angle.Atan2(normal.LengthXY, normal.Z));
        if (!(tilt > Upright)) return (0, lastTurn);
        var azimuth = Angle.Atan2(normal.Y, normal.X) + (Axes == TiltAxes.AC ? 90 : 0);
        return (tilt, azimuth + 360 * Math.Floor((lastTurn - azimuth) / 360 + 0.5));
    }

    /// <summary>The toolpath with rotary words. Arcs become chords.</summary>
    /// <param name="toolpath">The planned toolpath.</param>
    /// <param name="normal">The upward direction of the tool at a point in mm.</param>
    /// <param name="progress">Receives 0 to 1.</param>
    /// <param name="cancel">Cancels the work.</param>
    /// <exception cref="InvalidOperationException">The maximum tilt is out of range.</exception>
    public Toolpath Apply(Toolpath toolpath, Func<Vec3, Vec3> normal, IProgress<double>? progress = null, CancellationToken cancel = default)
    {
        if (toolpath is null) throw new ArgumentNullException(nameof(toolpath));
        if (normal is null) throw new ArgumentNullException(nameof(normal));
        var (tilt, turn) = (0.0, 0.0);
        return StraightPieces.Rebuilt(toolpath, toolpath.Start, Add, progress, cancel);

        void Add(ToolpathBuilder builder, Move piece)
        {
            if (piece.End != piece.Start) (tilt, turn) = Angles(normal(piece.End), turn);
            builder.Add(piece);
            builder.SetRotary(Axes == TiltAxes.AC ? tilt : 0, Axes == TiltAxes.BC ? tilt : 0, turn);
        }
    }

    private static bool Turns(double[]? angles) => angles is not null && Array.Exists(angles, a => a != 0);
}
