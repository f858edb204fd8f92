namespace Caterpillar.GCode;

/// <summary>The geometry of G2 and G3 as each firmware reads it.</summary>
internal sealed class ArcReader(FlavorRules rules, InterpreterState state)
{
    private const double NoChange = InterpreterState.NoChange;

    private bool IsClockwise => (state.Modes.Motion == 2) != (rules.MirroredZx && state.Modes.Plane == ArcPlane.ZX);

    /// <summary>Reads an arc in coordinates as written.</summary>
    /// <returns>The reason why the firmware rejects it, or null.</returns>
    public string? Read(ParsedLine line, Vec3 start, Vec3 end, out Arc arc)
    {
        arc = default;
        var plane = state.Modes.Plane;
        if (!rules.Arcs) return rules.Title + " does not support arcs.";
        if (state.Modes.Relative && !rules.ArcsInRelativeMode) return rules.Title + " rejects arcs in relative mode.";
        if (rules.ArcNamesEnd && !line.HasAny(plane switch { ArcPlane.XY => "XY", ArcPlane.ZX => "ZX", _ => "YZ" }))
            return rules.Title + " rejects arcs without an end point.";
        if (line.Find('P') >= 0 && rules.ArcTurns == ArcTurnsRule.Refused) return rules.Title + " rejects arcs with P.";
        bool hasI = line.TryGet('I', out var i), hasJ = line.TryGet('J', out var j), hasK = line.TryGet('K', out var k), hasR = line.TryGet('R', out var r);
        var centered = hasI || hasJ || hasK;
        if (hasR && centered && rules.RadiusAndCenter == RadiusAndCenterRule.Refused) return rules.Title + " rejects arcs with both R and a center.";
        if (hasR && rules.RadiusArcs && (!centered || rules.RadiusAndCenter == RadiusAndCenterRule.RadiusWins))
        {
            if (rules.RadiusInXyOnly && plane != ArcPlane.XY) return rules.Title + " accepts R only in the XY plane.";
            return ByRadius(start, end, r * state.Modes.Unit, out arc) ? null
                : rules.Title + " rejects arcs with R between equal points or points too far apart for R.";
        }
        if (centered)
        {
            var head = state.Head;
            return Centered(line, start, end, new Vec3(Center(head.X, i, hasI), Center(head.Y, j, hasJ), Center(head.Z, k, hasK)), out arc);
        }
        return hasR ? rules.Title + " does not support arcs with R." : rules.Title + " rejects arcs without a center.";
    }

    /// <summary>The number of P, or 0.</summary>
    public static int Turns(ParsedLine line) => line.TryGet('P', out var p) && p is >= 1 and < 1e6 ? (int)p : 0;

    private double Center(double from, double word, bool has)
        => !state.Modes.AbsoluteCenters ? from + word * state.Modes.Unit : has ? word * state.Modes.Unit : from;

    private string? Centered(ParsedLine line, Vec3 start, Vec3 end, Vec3 center, out Arc arc)
    {
        arc = new Arc(center, 0, state.Modes.Plane);
        var clockwise = IsClockwise;
        var (su, sv, _) = arc.Local(start);
        var (eu, ev, _) = arc.Local(end);
        var radius = Math.Sqrt(su * su + sv * sv);
        if (radius <= NoChange) return rules.Title + " rejects arcs whose center is their start.";
        if (rules.ArcTolerance is { } tolerance && tolerance.Refuses(radius, Math.Sqrt(eu * eu + ev * ev)))
            return rules.Title + " rejects arcs whose end is not on their circle.";
        var closed = Math.Abs(su - eu) <= NoChange && Math.Abs(sv - ev) <= NoChange;
        if (line.Find('P') >= 0 && rules.ArcTurns == ArcTurnsRule.OneCircle && (!closed || Turns(line) != 1))
            return rules.Title + " accepts only P1 of a full circle.";
        double sweep;
        if (closed)
        {
            if (state.Modes.Motion == 3 && !rules.CounterclockwiseCircles) return rules.Title + " cannot draw a full circle with G3.";
            sweep = 360;
        }
        else
        {
            var turn = Angle.Atan2(ev, eu) - Angle.Atan2(sv, su);
            sweep = clockwise ? -turn : turn;
            if (sweep < 0) sweep += 360;
            if (sweep >= 360) sweep -= 360;
        }
        arc = arc with { Sweep = clockwise ? -sweep : sweep };
        return null;
    }

    // The shorter arc for R > 0, the longer one for R < 0; where R is too short, a half circle about the middle of the chord.
    private bool ByRadius(Vec3 start, Vec3 end, double radius, out Arc arc)
    {
        arc = new Arc(start, 0, state.Modes.Plane);
        var clockwise = IsClockwise;
        var (u, v, _) = arc.Local(end);
        var chord = Math.Sqrt(u * u + v * v);
        if (!(chord > NoChange) || radius == 0 || double.IsInfinity(chord) || double.IsInfinity(radius)) return false;
        var size = Math.Abs(radius);
        if (chord / 2 > size * (1 + rules.ShortRadius) + rules.ShortRadiusMm + NoChange) return false;
        var height2 = size * size - chord * chord / 4;
        var height = height2 > 0 ? Math.Sqrt(height2) : 0;
        // Counterclockwise and short: the center lies to the left of the chord.
        var side = clockwise != radius < 0 ? -1 : 1;
        var cu = u / 2 - side * height * v / chord;
        var cv = v / 2 + side * height * u / chord;
        var half = height > 0 ? Angle.ToDegrees(Math.Asin(Math.Min(chord / 2 / size, 1))) : 90;
        var sweep = radius < 0 ? 360 - 2 * half : 2 * half;
        arc = arc with { Center = arc.World(cu, cv, arc.Across(start)), Sweep = clockwise ? -sweep : sweep };
        return true;
    }
}
