namespace Caterpillar.Toolpaths;

/// <summary>A straight move of the tip over the part, while the rotary axes turn evenly. Positions in mm, words in degrees.</summary>
internal readonly record struct HeadMove(Vec3 From, Vec3 FromTurns, Vec3 To, Vec3 ToTurns)
{
    /// <summary>A part of it, between two shares of 0 to 1.</summary>
    public HeadMove Part(double from, double to)
        => new(Vec3.Lerp(From, To, from), Vec3.Lerp(FromTurns, ToTurns, from), Vec3.Lerp(From, To, to), Vec3.Lerp(FromTurns, ToTurns, to));
}

/// <summary>
/// Nozzle, head and what carries them on a machine with rotary axes, as they stand over the part: the nozzle is round about the tool, and as wide above its
/// outline as at its end. A move is the hulls of the poses at the ends of its parts; how far a turning body leaves them is added. It misses nothing.
/// </summary>
/// <param name="kinematics">The rotary axes.</param>
/// <param name="outline">Radius and height of the nozzle, from the tip outward, mm.</param>
/// <param name="boxes">Boxes relative to the tip, mm.</param>
internal sealed class LeaningHead(Kinematics kinematics, IReadOnlyList<(double Radius, double Height)> outline, IReadOnlyList<Bounds> boxes)
{
    /// <summary>The head goes on above its outline for so many mm.</summary>
    public const double Above = 100;

    // How far a turning body may leave the hull of two poses, mm.
    private const double Bulge = 0.02;
    private const int MostParts = 512;
    private readonly HeadShape _shape = new(outline);

    // No point of the head is farther from the tip than the radius of its flat and this, times its height.
    private readonly double _slant = outline.Where(p => p.Height > 0).Select(p => p.Radius / p.Height + 1).Append(1).Max();

    // The outline, and as wide as at its end above.
    private readonly (double Radius, double Height)[] _whole = Whole(outline);

    // The part of the nozzle that may dig into gentle slopes, and the rest.
    private readonly (double Radius, double Height)[] _tip = Tip(outline);
    private readonly (double Radius, double Height)[] _rest = Rest(outline);

    /// <summary>What the nozzle does to strands; the strand that it hits or digs into.</summary>
    /// <param name="strands">What is there.</param>
    /// <param name="move">The move.</param>
    /// <param name="tolerance">Maximum depth of contact, mm.</param>
    /// <param name="hit">The strand.</param>
    public HeadContact Meets(StrandGrid strands, in HeadMove move, double tolerance, out Strand? hit)
    {
        hit = null;
        var contact = HeadContact.None;
        var reach = _whole[_whole.Length - 1].Radius + _whole[_whole.Length - 1].Height;
        foreach (var (a, b, turn, bulge) in Parts(move, reach, tolerance, kinematics.Pose, kinematics.ToolTurn(move.FromTurns, move.ToTurns)))
        {
            var apart = (a.ZAxis + b.ZAxis).Unit();
            var whole = Hull(a, b, _whole);
            ConvexBody[]? tip = null, rest = null, raised = null;
            ConvexBody? cone = null;
            var shift = a.Shift.DistanceTo(b.Shift) + bulge;
            foreach (var strand in strands.Near(whole, bulge, apart, box => Comes(box, a, shift, turn)))
            {
                if (!whole.Meets(strand.Body, bulge, apart)) continue;
                if (AnyMeets(rest ??= Frustums(a, b, _rest), strand.Body, bulge, apart))
                {
                    hit = strand;
                    return HeadContact.Hits;
                }
                if (!AnyMeets(tip ??= Frustums(a, b, _tip), strand.Body, bulge, apart)) continue;
                var top = _tip[_tip.Length - 1].Height;
                cone ??= Hull(a, b, [(0, 0), (top, top)]);
                raised ??= Frustums(a, b, Raised(top));
                hit = strand;
                if (cone.Meets(strand.Body.MiddleLine(), bulge, apart) || AnyMeets(raised, strand.Body, bulge, apart)) return HeadContact.Hits;
                contact = HeadContact.Digs;
            }
        }
        return contact;
    }

    /// <summary>True if a box meets strands.</summary>
    /// <param name="strands">What is there.</param>
    /// <param name="move">The move.</param>
    /// <param name="tolerance">Maximum depth of contact, mm.</param>
    /// <param name="box">Number of the box.</param>
    /// <param name="isCarried">It does not turn with the axes of the head.</param>
    /// <param name="hit">The strand.</param>
    public bool MeetsBox(StrandGrid strands, in HeadMove move, double tolerance, int box, bool isCarried, out Strand? hit)
    {
        hit = null;
        var body = boxes[box];
        var turn = Angle.ToRadians(kinematics.Turn(move.FromTurns, move.ToTurns));
        var reach = Math.Max(body.Min.Length, body.Max.Length);
        foreach (var (a, b, _, bulge) in Parts(move, reach, tolerance, isCarried ? kinematics.Carriage : kinematics.Pose, (turn, turn * turn)))
        {
            var hull = ConvexBody.Of(body, a, b);
            var apart = (a.ZAxis + b.ZAxis).Unit();
            foreach (var strand in strands.Near(hull, bulge, apart))
            {
                if (!hull.Meets(strand.Body, bulge, apart)) continue;
                hit = strand;
                return true;
            }
        }
        return false;
    }

    // False if the nozzle surely does not come to a box from a pose to the next, by a shift in mm and a turn in radians: it stays about the outline in the
    // first pose, farther away by as much as it moves.
    private bool Comes(in Bounds box, in Affine pose, double shift, double turn)
    {
        var v = box.Center - pose.Shift;
        var height = Vec3.Dot(v, pose.ZAxis);
        var radius = box.Size.Length / 2;
        if (!(turn * _slant < 0.5)) return true;
        // A turn moves what is higher or wider by more.
        var moved = radius + (shift + turn * (_shape.FlatRadius + _slant * Math.Max(0, height + radius))) / (1 - turn * _slant);
        if (!(height + moved > 0)) return false;
        var most = _shape.Reach(height + moved) + moved;
        return v.LengthSquared - height * height <= most * most;
    }

    // Poses at the ends of the parts of a move, raised by the tolerance, the turn between them in radians, and how far a body leaves their hull.
    private IEnumerable<(Affine From, Affine To, double Turn, double Bulge)> Parts(
        HeadMove move, double reach, double tolerance, Func<Vec3, Vec3, Affine> pose, (double Angle, double Bend) turn)
    {
        var count = (int)Math.Min(MostParts, Math.Max(1, Math.Ceiling(Math.Sqrt(turn.Bend * reach / (8 * Bulge)))));
        var bulge = reach * turn.Bend / (8.0 * count * count) + 1e-9;
        var last = At(0);
        for (var k = 1; k <= count; k++)
        {
            var next = At((double)k / count);
            yield return (last, next, turn.Angle / count, bulge);
            last = next;
        }

        Affine At(double s)
        {
            var at = pose(Vec3.Lerp(move.From, move.To, s), Vec3.Lerp(move.FromTurns, move.ToTurns, s));
            return at with { Shift = at.Shift + at.ZAxis * tolerance };
        }
    }

    private static bool AnyMeets(ConvexBody[] bodies, ConvexBody other, double distance, Vec3 apart)
    {
        foreach (var body in bodies)
        {
            if (body.Meets(other, distance, apart)) return true;
        }
        return false;
    }

    private static ConvexBody[] Frustums(in Affine a, in Affine b, (double Radius, double Height)[] points)
    {
        var bodies = new ConvexBody[Math.Max(0, points.Length - 1)];
        for (var i = 0; i < bodies.Length; i++) bodies[i] = Hull(a, b, [points[i], points[i + 1]]);
        return bodies;
    }

    private static ConvexBody Hull(in Affine a, in Affine b, (double Radius, double Height)[] points)
    {
        var discs = new Disc[2 * points.Length];
        for (var i = 0; i < points.Length; i++)
        {
            var (radius, height) = points[i];
            discs[2 * i] = new Disc(a.Shift + a.ZAxis * height, a.ZAxis, radius);
            discs[2 * i + 1] = new Disc(b.Shift + b.ZAxis * height, b.ZAxis, radius);
        }
        return new ConvexBody(discs);
    }

    private static (double Radius, double Height)[] Whole(IReadOnlyList<(double Radius, double Height)> outline)
        => [.. outline, (outline[outline.Count - 1].Radius, outline[outline.Count - 1].Height + Above)];

    private static (double Radius, double Height)[] Rest(IReadOnlyList<(double Radius, double Height)> outline)
    {
        var begin = Tip(outline).Last();
        return [begin, .. outline.Where(p => p.Radius > begin.Radius), Whole(outline).Last()];
    }

    private static (double Radius, double Height)[] Tip(IReadOnlyList<(double Radius, double Height)> outline)
    {
        var shape = new HeadShape(outline);
        var most = Math.Min(3 * shape.FlatRadius, outline[outline.Count - 1].Radius);
        return [.. outline.Where(p => p.Radius < most), (most, shape.HeightAt(most))];
    }

    // The tip, higher by as much as its flat is wide, up to its own height.
    private (double Radius, double Height)[] Raised(double top)
    {
        var flat = _shape.FlatRadius;
        return top > flat ? [.. _tip.Select(p => (p.Radius, p.Height + flat)).Where(p => p.Item2 <= top), (_shape.Reach(top - flat), top)] : [];
    }
}
