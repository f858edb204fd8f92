namespace Caterpillar.Toolpaths;

/// <summary>
/// A collision query for a head that moves straight from one point to another, also up or down. It records whether the head digs into something. It misses no
/// extrusion.
/// </summary>
internal struct HeadQuery
{
    // Length of a path that counts as straight up, mm.
    private const double Upright = 0.03;

    // mm; far more than rounding.
    private const double Same = 1e-9;

    public readonly Vec3 From, To;

    /// <summary>Maximum depth of contact, mm.</summary>
    public readonly double Tolerance;
    public readonly HeadShape Head;

    /// <summary>Ignore extrusions that the head only digs into.</summary>
    public bool HitsOnly;
    public bool Digs;

    // The direction and length of the path seen from above, and its rise for each mm; none where it goes straight up.
    private readonly double _ux, _uy, _length, _rise;

    // Half the extent of a square in this direction, and across it, for half a side of 1.
    private readonly double _spread;
    private readonly bool _isUpright;

    public HeadQuery(Vec3 from, Vec3 to, double tolerance, HeadShape head, bool hitsOnly)
    {
        (From, To, Tolerance, Head, HitsOnly) = (from, to, tolerance, head, hitsOnly);
        double dx = to.X - from.X, dy = to.Y - from.Y;
        _length = Math.Sqrt(dx * dx + dy * dy);
        _isUpright = _length <= Upright;
        (_ux, _uy) = _length > 0 ? (dx / _length, dy / _length) : (1, 0);
        _spread = Math.Abs(_ux) + Math.Abs(_uy);
        if (!_isUpright) _rise = (to.Z - from.Z) / _length;
    }

    /// <summary>True if the head hits. Digging is recorded.</summary>
    public bool Meets(in Extrusion extrusion)
    {
        var most = extrusion.Top - Math.Min(From.Z, To.Z) - Tolerance;
        if (!(most > 0)) return false;
        // Near the path, it may be less high above it; what is less high is met only nearer to the path.
        for (double before = double.PositiveInfinity, excess; most < 0.8 * before; (before, most) = (most, excess))
        {
            if (IsPassed(extrusion, Head.LineAbove(most, HitsOnly), out excess)) return false;
        }
        if (!HitsOnly && !Touches(extrusion, From, To, false)) return false;
        if (Touches(extrusion, From, To, true) && (!extrusion.IsSloped || TouchesSloped(extrusion))) return true;
        if (HitsOnly) return false;
        Digs = HitsOnly = true;
        return false;
    }

    /// <summary>Whether extrusions as high above the tip as a line is right may be met from a part of the path.</summary>
    public readonly bool MayMeet(in DepositBlock block, in (Vec3 From, Vec3 To) part, in ReachLine line)
    {
        if (block.Rise == 0 || line.Slope * block.Rise >= 1) return true;
        var above = Math.Max(block.Above(part.From), block.Above(part.To)) - Tolerance;
        var excess = (above + block.Rise * line.At(0, block.Half)) / (1 - line.Slope * block.Rise);
        // Lower ones have a lower line.
        return excess > Same ? excess > 0.7 * line.Most || MayMeet(block, part, Head.LineAbove(excess, HitsOnly)) : excess > -Same;
    }

    /// <summary>The part of the path within some distance of a square, seen from above, and its distance in mm, negative if they may overlap.</summary>
    public readonly (Vec3 From, Vec3 To) Near(double x, double y, double half, double distance, out double away)
    {
        x -= From.X;
        y -= From.Y;
        double along = x * _ux + y * _uy, around = half * _spread, far = distance + around;
        away = Math.Max(Math.Abs(y * _ux - x * _uy), Math.Max(-along, along - _length)) - around;
        return _isUpright ? (From, To) : (Vec3.Lerp(From, To, Share(along - far)), Vec3.Lerp(From, To, Share(along + far)));
    }

    // True if an extrusion is clearly out of reach of the infinite line of the path. The sideways reach of the head grows with the height of the extrusion
    // above the slope of the path. Also the height of the extrusion above the tip, at most, mm.
    private readonly bool IsPassed(in Extrusion extrusion, in ReachLine line, out double excess)
    {
        excess = line.Most;
        var cut = line.Slope * _rise;
        if (_isUpright || cut * cut >= 1) return false;
        // What is farther from the line of the path than (reach / shrink) is out of reach.
        var shrink = Math.Sqrt(1 - cut * cut);
        double ax = extrusion.Ax - From.X, ay = extrusion.Ay - From.Y, bx = extrusion.Bx - From.X, by = extrusion.By - From.Y;
        double aside = ay * _ux - ax * _uy, bside = by * _ux - bx * _uy;
        var level = From.Z + Tolerance;
        double a = extrusion.Az - level - _rise * (ax * _ux + ay * _uy), b = extrusion.Bz - level - _rise * (bx * _ux + by * _uy);
        excess = Math.Max(a, b) + Math.Abs(_rise) * line.At(excess, extrusion.Half) + Same;
        // It and the path lie in parallel planes.
        double across = (b - a) / (bside - aside), gradient = Math.Sqrt(across * across + _rise * _rise), grown = 1 - line.Slope * gradient;
        if (grown > 0) excess = Math.Min(excess, (a - across * aside + gradient * line.At(0, extrusion.Half)) / grown + Same);
        if (excess <= 0) return true;
        double reachA = line.At(a, extrusion.Half) + Same, reachB = line.At(b, extrusion.Half) + Same;
        if (Math.Abs(aside) * shrink <= reachA || Math.Abs(bside) * shrink <= reachB) return false;
        // It crosses the line.
        return aside > 0 == bside > 0 || reachA + (reachB - reachA) * aside / (aside - bside) < 0;
    }

    // 0 to 1.
    private readonly double Share(double along) => Math.Min(1, Math.Max(0, along / _length));

    // An extrusion that goes up or down is level across itself. Where the path is over it, or beside it, the nearest of its points count; then its round ends.
    private readonly bool TouchesSloped(in Extrusion extrusion)
    {
        Vec3 a = From, b = To, first = extrusion.A, last = extrusion.B;
        var half = extrusion.Half;
        var along = (last - first).WithZ(0);
        if (!(along.Length > Upright)) return true;
        along = along.Unit();
        var aside = new Vec3(along.Y, -along.X);
        double from = Vec3.Dot(a - first, aside), to = Vec3.Dot(b - first, aside);
        double left = Crossing(-half), right = Crossing(half), near = Math.Min(left, right), far = Math.Max(left, right);
        var thin = extrusion with { Half = 0 };
        if (Touches(thin, Over(0), Over(near), true) || Touches(thin, Over(near), Over(far), true) || Touches(thin, Over(far), Over(1), true)) return true;
        var rises = last.Z > first.Z;
        return ((rises || !extrusion.IsJoined) && TouchesEnd(last, along, half)) || ((!rises || !extrusion.IsJoined) && TouchesEnd(first, -along, half));

        double Crossing(double at) => from == to ? 0 : Math.Min(1, Math.Max(0, (at - from) / (to - from)));

        Vec3 Over(double t) => Vec3.Lerp(a, b, t) - aside * Math.Min(half, Math.Max(-half, from + (to - from) * t));
    }

    // The half of a disc that lies in a direction.
    private readonly bool TouchesEnd(Vec3 end, Vec3 outward, double half)
    {
        double low = 0, high = 1, start = Vec3.Dot((From - end).WithZ(0), outward), step = Vec3.Dot((To - From).WithZ(0), outward);
        return FlatSegment.Slab(start, step, 0, double.PositiveInfinity, ref low, ref high)
            && Touches(Extrusion.Of(end, end, half), Vec3.Lerp(From, To, low), Vec3.Lerp(From, To, high), true);
    }

    private readonly bool Touches(in Extrusion extrusion, Vec3 a, Vec3 b, bool lenient)
    {
        var most = extrusion.Top - Math.Min(a.Z, b.Z) - Tolerance;
        for (double least = 0, end; least < most; least = end)
        {
            var (start, slope, until) = Head.PieceAbove(least, extrusion.Half, lenient);
            end = Math.Max(until, least + Same);
            if (new SlopePass(extrusion, a, b, Tolerance, slope, least, end + Same).Least <= start + Same) return true;
        }
        return false;
    }
}

/// <summary>Contact of a head with the print.</summary>
internal enum HeadContact
{
    None,

    /// <summary>Only the flat of its tip touches a slope of up to 45° next to it.</summary>
    Digs,

    Hits,
}
