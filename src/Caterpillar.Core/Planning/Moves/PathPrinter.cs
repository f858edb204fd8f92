namespace Caterpillar.Planning;

/// <summary>Turns the segments of a path into printing moves, with compensation for the pressure lag at its ends.</summary>
internal sealed class PathPrinter(PlanRules rules, MoveEmitter emitter, PlanReport counts, Deposit? deposit, SlowedRoles slowed, SlopedFeed feed)
{
    // A short path builds up less pressure: what is extruded early, left out at the end or left open is at most this share of it.
    private const double MaxShare = 0.1;

    /// <summary>Prints a path from its start, where the head is.</summary>
    /// <param name="path">The path.</param>
    /// <param name="length">Its length, mm.</param>
    /// <param name="flows">The path before it went on to its start: the material flows.</param>
    /// <param name="goesOn">The next path goes on from its end.</param>
    /// <param name="lines">The line of each segment in a script.</param>
    public void Print(PrintPath path, double length, bool flows, bool goesOn, int[]? lines)
    {
        var stopAt = double.PositiveInfinity;
        double startDistance = flows ? 0 : rules.Settings.StartDistance, stopDistance = goesOn ? 0 : rules.Settings.CoastingDistance;
        if (stopDistance > 0 && !EndsLevel(path, stopDistance)) stopDistance = 0;
        if (!rules.AddsNothing && (startDistance > 0 || stopDistance > 0) && path.BeadOf(0).Area > 0)
        {
            counts.LaggedPaths++;
            if (stopDistance > 0) stopAt = length - Math.Min(stopDistance, length * MaxShare);
            var start = Math.Min(startDistance, length * MaxShare);
            if (start > 0) emitter.Prime(emitter.ToolRules.EOf(start * path.BeadOf(0).Area), emitter.ToolRules.DeretractionSpeed);
        }
        var gap = rules.Settings.SeamGap;
        if (!rules.AddsNothing && gap > 0 && path.IsClosed && path.Role is Role.OuterWall or Role.InnerWall && EndsLevel(path, gap))
            stopAt = Math.Min(stopAt, length - Math.Min(gap, length * MaxShare));
        var points = path.RawPoints;
        var done = 0.0;
        for (var i = 0; i < path.SegmentCount; i++)
        {
            var from = points[i];
            var to = i + 1 == points.Length ? points[0] : points[i + 1];
            var arc = path.ArcOf(i);
            var segment = arc is { } turn ? turn.Length(from, to) : from.DistanceTo(to);
            if (!(segment > 0))
            {
                counts.EmptySegments++;
                continue;
            }
            if (lines is not null) emitter.Line = lines[i];
            var bead = path.BeadOf(i);
            var isFirst = rules.LayerOf(path, Math.Max(from.Z, to.Z)) == 0;
            var speed = rules.SpeedOf(path, bead, isFirst);
            var most = emitter.ToolRules.MaxFlow;
            if (speed * bead.Area >= most) slowed.Add(path.Role, bead.Speed > 0 ? bead.Speed : rules.Settings.SpeedOf(path.Role, isFirst), speed, most);
            speed = feed.Of(from, to, segment, speed);
            var printed = Math.Min(segment, Math.Max(stopAt - done, 0));
            done += segment;
            if (printed >= segment)
            {
                emitter.Print(to, segment * bead.Area, speed, path.Role, arc);
            }
            else
            {
                var t = printed / segment;
                var stop = arc is { } a ? a.PointAt(from, to, t) : Vec3.Lerp(from, to, t);
                if (printed > 0) emitter.Print(stop, printed * bead.Area, speed, path.Role, Part(arc, t));
                emitter.Coast(to, speed, Part(arc, 1 - t));
            }
            deposit?.Add(from, to, bead, arc, rules.Settings.BeadShape);
            emitter.Reached(Math.Max(from.Z, to.Z));
        }
    }

    // Beside a slope the nozzle may go as deep as an extrusion is pressed, but not without one.
    private static bool EndsLevel(PrintPath path, double distance)
    {
        var points = path.RawPoints;
        var end = path.End;
        for (var i = path.SegmentCount - 1; i >= 0 && distance > 0; i--)
        {
            if (Math.Abs(points[i].Z - end.Z) > TravelPlanner.Flat) return false;
            distance -= path.LengthOf(i);
        }
        return true;
    }

    private static Arc? Part(Arc? arc, double share) => arc is { } a ? a with { Sweep = a.Sweep * share } : null;
}
