namespace Caterpillar.Toolpaths;

/// <summary>
/// The rotary axes of a machine that tilts its tool or turns the work, and what its words mean. Positions are in mm in the frame of the part, which turns with
/// the work; directions point from the tip to the head. Rotary words are A, B and C in degrees and are never reduced by full turns. Immutable.
/// </summary>
/// <param name="axes">Outer axes first: those that carry others come before them.</param>
/// <param name="isPolar">There is no Y axis: an axis of the work brings every place under the nozzle.</param>
public sealed class Kinematics(IReadOnlyList<RotaryAxis> axes, bool isPolar = false)
{
    // Degrees: where the tool is as good as upright its azimuth says nothing.
    private const double Upright = 0.05;

    // Where the turn is free: sine of a tilt, or mm.
    private const double Pole = 1e-12;

    // Degrees: a hair beyond the end of an axis.
    private const double Rounding = 1e-9;
    private readonly RotaryAxis[] _head = [.. axes.Where(a => !a.TurnsWork)];
    private readonly RotaryAxis[] _work = [.. axes.Where(a => a.TurnsWork)];
    private readonly RotaryAxis? _turn = axes.FirstOrDefault(a => a.About == PathAxis.Z);
    private readonly RotaryAxis? _tilt = axes.FirstOrDefault(a => a.About != PathAxis.Z);

    /// <summary>The axes, outer ones first.</summary>
    public IReadOnlyList<RotaryAxis> Axes => axes;

    /// <summary>What makes a list of axes no such machine; null if they are one.</summary>
    public static string? Problem(IReadOnlyList<RotaryAxis> axes)
    {
        if (axes.Select(a => a.Word).Distinct().Count() < axes.Count) return "uses a word twice";
        if (axes.Count(a => a.About == PathAxis.Z) > 1 || axes.Count(a => a.About != PathAxis.Z) > 1) return "may have one axis about z and one about x or y";
        // The turn about Z has to move the tilted tool, or the part in front of it.
        var order = axes.Where(a => a.TurnsWork).Reverse().Concat(axes.Where(a => !a.TurnsWork)).ToArray();
        return order.Length == 2 && order[1].About == PathAxis.Z ? "has an axis about z that does not turn the tilt of the tool" : null;
    }

    /// <summary>
    /// The directions of the usual machine whose words a toolpath has, if nothing is known of it: B and C, or A and C. Null if it has no rotary words, or turns
    /// both A and B. Its axes have no place.
    /// </summary>
    public static Kinematics? Guess(Toolpath toolpath)
    {
        if (toolpath is null) throw new ArgumentNullException(nameof(toolpath));
        bool Has(Predicate<Vec3> turn) => toolpath.Blocks.Any(b => b.HasTurns && Array.Exists(b.Columns.Turns!, turn));
        var (hasA, hasB) = (Has(turn => turn.X != 0), Has(turn => turn.Y != 0));
        if (!toolpath.HasTurns || (hasA && hasB)) return null;
        var tilt = hasA ? new RotaryAxis(RotaryWord.A, false, PathAxis.X, Vec3.Zero) : new RotaryAxis(RotaryWord.B, false, PathAxis.Y, Vec3.Zero);
        return new Kinematics([new RotaryAxis(RotaryWord.C, false, PathAxis.Z, Vec3.Zero), tilt]);
    }

    /// <summary>True if there is no Y axis, and an axis that stands for it.</summary>
    public bool IsPolar { get; } = isPolar && axes.Any(a => a.TurnsWork && a.About == PathAxis.Z);

    /// <summary>True if the machine can lean the tool over the part.</summary>
    public bool Tilts => _tilt is not null;

    /// <summary>The unit vector from the nozzle tip along the tool.</summary>
    public Vec3 Direction(Vec3 words) => FromMachine(HeadTurned(Vec3.UnitZ, words), words);

    /// <summary>The head as it stands over the part: images of the axes of its own frame, whose origin is the tip at a position.</summary>
    public Affine Pose(Vec3 tip, Vec3 words) => new(
        FromMachine(HeadTurned(Vec3.UnitX, words), words), FromMachine(HeadTurned(Vec3.UnitY, words), words), Direction(words), tip);

    /// <summary>What carries the head, as it stands over the part: it turns with no axis of the head. Its origin is the tip at words of zero.</summary>
    public Affine Carriage(Vec3 tip, Vec3 words)
    {
        var at = ToPart(Machine(tip, words), words, swings: false);
        return new(FromMachine(Vec3.UnitX, words), FromMachine(Vec3.UnitY, words), FromMachine(Vec3.UnitZ, words), at);
    }

    /// <summary>The linear words with which the tip stands at a place of the part.</summary>
    public Vec3 Machine(Vec3 tip, Vec3 words)
    {
        for (var i = _work.Length - 1; i >= 0; i--) tip = _work[i].Point + _work[i].Turned(tip - _work[i].Point, -_work[i].Angle(words));
        return tip - Swing(words);
    }

    /// <summary>The place of the tip in the part, from the words of the machine.</summary>
    public Vec3 Tip(Vec3 machine, Vec3 words) => ToPart(machine, words, swings: true);

    /// <summary>
    /// Rotary words that bring the tip to a place with the tool along a direction, up to full turns: two of them, or one. What no axis can do is left out: with
    /// one tilting axis the tool leans in its plane only. Where the turn is free it stays.
    /// </summary>
    /// <param name="tip">The place; it matters for polar machines only.</param>
    /// <param name="tool">The direction, of any length.</param>
    /// <param name="last">The words before.</param>
    public IReadOnlyList<Vec3> Solutions(Vec3 tip, Vec3 tool, Vec3 last = default)
    {
        var aside = tool.LengthXY;
        if (IsPolar) return Polar(tip, tool, last);
        if (_turn is null || _tilt is null)
            return [_tilt is null ? last : _tilt.WithAngle(last, InPlane(_tilt, tool))];
        var tilt = Basics.Angle.Atan2(aside, tool.Z);
        var isFree = !(aside > Pole * tool.Length);
        var turn = isFree ? _turn.Angle(last) : Azimuth(_tilt, tool);
        var first = _tilt.WithAngle(_turn.WithAngle(last, turn), tilt);
        return isFree ? [first] : [first, _tilt.WithAngle(_turn.WithAngle(last, turn + 180), -tilt)];
    }

    /// <summary>
    /// The words with the smallest change from the words before, by the time that the slowest axis takes (or degrees, if a speed is unknown), within the limits
    /// if there are such words. A tool that is as good as upright stands upright, and its turn stays.
    /// </summary>
    public Vec3 Nearest(Vec3 tip, Vec3 tool, Vec3 last)
    {
        tool = Snapped(tool);
        Vec3? best = null;
        var (most, sum, isIn) = (0.0, 0.0, false);
        foreach (var solution in Solutions(tip, tool, last))
        {
            var words = NearestTurns(solution, last, out var within);
            var (largest, all) = Change(last, words);
            var better = best is null || (within != isIn ? within : largest < most - 1e-9 || (largest < most + 1e-9 && all < sum - 1e-9));
            if (better) (best, most, sum, isIn) = (words, largest, all, within);
        }
        return best!.Value;
    }

    /// <summary>The direction; up where it is as good as upright, because its azimuth says nothing there.</summary>
    internal static Vec3 Snapped(Vec3 tool) => Basics.Angle.Atan2(tool.LengthXY, tool.Z) < Upright ? Vec3.UnitZ : tool;

    /// <summary>The same words up to full turns, nearest to others, and within the limits where they can be.</summary>
    public Vec3 NearestTurns(Vec3 words, Vec3 last, out bool isWithin)
    {
        foreach (var axis in Axes)
        {
            var word = axis.Of(words);
            word += 360 * Math.Floor((axis.Of(last) - word) / 360 + 0.5);
            if (word > axis.Max + Rounding) word -= 360 * Math.Ceiling((word - axis.Max) / 360);
            else if (word < axis.Min - Rounding) word += 360 * Math.Ceiling((axis.Min - word) / 360);
            words = axis.With(words, word);
        }
        isWithin = IsWithin(words);
        return words;
    }

    /// <summary>True if all words are within the limits of their axes.</summary>
    public bool IsWithin(Vec3 words) => Axes.All(axis => axis.Of(words) >= axis.Min - Rounding && axis.Of(words) <= axis.Max + Rounding);

    /// <summary>The largest and the sum of the times (or of the degrees) in which the axes go from one position to another.</summary>
    internal (double Largest, double Sum) Change(Vec3 from, Vec3 to)
    {
        var timed = Axes.All(a => !double.IsInfinity(a.MaxSpeed));
        var (largest, sum) = (0.0, 0.0);
        foreach (var axis in Axes)
        {
            var change = Math.Abs(axis.Of(to) - axis.Of(from)) / (timed ? axis.MaxSpeed : 1);
            (largest, sum) = (Math.Max(largest, change), sum + change);
        }
        return (largest, sum);
    }

    /// <summary>Degrees by which a body of the head turns over the part between two positions, at most.</summary>
    internal double Turn(Vec3 from, Vec3 to) => Axes.Sum(a => Math.Abs(a.Of(to) - a.Of(from)));

    /// <summary>
    /// What a round tool turns over the part between two positions, where its turn about itself does not count, at most: the angle in radians, and its bend,
    /// the second derivative of a point over the move for each mm of its distance from the tip.
    /// </summary>
    internal (double Angle, double Bend) ToolTurn(Vec3 from, Vec3 to)
    {
        if (_tilt is null) return default;
        double Change(RotaryAxis axis) => Basics.Angle.ToRadians(Math.Abs(axis.Of(to) - axis.Of(from)));
        var (tilt, turn) = (Change(_tilt), _turn is null ? 0 : Change(_turn));
        var most = Math.Max(Math.Abs(_tilt.Angle(from)), Math.Abs(_tilt.Angle(to)));
        var aside = most < 90 ? Basics.Angle.Sin(most) : 1;
        var angle = 2 * Basics.Angle.Sin(Math.Min(most, 180) / 2) * turn + tilt;
        return (angle, 2 * turn * tilt + aside * turn * turn + angle * angle);
    }

    private Vec3 HeadTurned(Vec3 v, Vec3 words)
    {
        for (var i = _head.Length - 1; i >= 0; i--) v = _head[i].Turned(v, _head[i].Angle(words));
        return v;
    }

    private Vec3 FromMachine(Vec3 v, Vec3 words)
    {
        foreach (var axis in _work) v = axis.Turned(v, axis.Angle(words));
        return v;
    }

    // Where the tip is, seen from where it was at words of zero.
    private Vec3 Swing(Vec3 words)
    {
        var tip = Vec3.Zero;
        for (var i = _head.Length - 1; i >= 0; i--) tip = _head[i].Point + _head[i].Turned(tip - _head[i].Point, _head[i].Angle(words));
        return tip;
    }

    private Vec3 ToPart(Vec3 machine, Vec3 words, bool swings)
    {
        if (swings) machine += Swing(words);
        foreach (var axis in _work) machine = axis.Point + axis.Turned(machine - axis.Point, axis.Angle(words));
        return machine;
    }

    private IReadOnlyList<Vec3> Polar(Vec3 tip, Vec3 tool, Vec3 last)
    {
        var center = _turn!.Point;
        var arm = tip - center;
        var radius = arm.LengthXY;
        var isFree = !(radius > Pole);
        // Where the part meets the plane of X and Z: on one side of the axis, or on the other.
        var lead = isFree ? 0 : Basics.Angle.Atan2(-center.Y, Math.Sqrt(Math.Max(0, radius * radius - center.Y * center.Y)));
        var azimuth = Basics.Angle.Atan2(arm.Y, arm.X);
        return [Facing(isFree ? _turn.Angle(last) : azimuth - lead), Facing(isFree ? _turn.Angle(last) + 180 : azimuth - 180 + lead)];

        Vec3 Facing(double turn)
        {
            var words = _turn.WithAngle(last, turn);
            return _tilt is null ? words : _tilt.WithAngle(words, InPlane(_tilt, _turn.Turned(tool, -turn)));
        }
    }

    // The tilt that comes nearest to a direction, degrees.
    private static double InPlane(RotaryAxis tilt, Vec3 tool)
        => tilt.About == PathAxis.X ? Basics.Angle.Atan2(-tool.Y, tool.Z) : Basics.Angle.Atan2(tool.X, tool.Z);

    private static double Azimuth(RotaryAxis tilt, Vec3 tool)
        => tilt.About == PathAxis.X ? Basics.Angle.Atan2(tool.X, -tool.Y) : Basics.Angle.Atan2(tool.Y, tool.X);
}
