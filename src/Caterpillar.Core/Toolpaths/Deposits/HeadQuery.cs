namespace Caterpillar.Toolpaths;

/// <summary>
/// A collision query for a head that moves straight from one point to another, also up or down. It records whether the head digs into something. It misses no
/// extrusion.
/// </summary>
internal struct HeadQuery
{
    // Length of a path that counts as straight up, mm.
    private const double Upright = 0.03;

    // Of planes; steeper ones tell nothing.
    private const double Steepest = 100;

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
        if (IsPassed(extrusion, most)) return false;
        if (!HitsOnly && !Touches(extrusion, From, To, false)) return false;
        if (Touches(extrusion, From, To, true) && (!extrusion.IsSloped || TouchesSloped(extrusion))) return true;
        if (HitsOnly) return false;
        Digs = HitsOnly = true;
        return false;
    }

    /// <summary>Whether extrusions of a block or before it, at most so many mm above the tip, may be met from a part of the path.</summary>
    public readonly bool MayMeet(in DepositBlock block, in (Vec3 From, Vec3 To) part, double most)
        => Math.Max(block.Above(part.From), block.Above(part.To)) + Head.Depth(block.Rise, block.Half, most, HitsOnly) > Tolerance - Same;

    /// <summary>The part of the path within some distance of a square, seen from above, and its distance in mm, negative if they may overlap.</summary>
    public readonly (Vec3 From, Vec3 To) Near(double x, double y, double half, double distance, out double away)
    {
        x -= From.X;
        y -= From.Y;
        double along = x * _ux + y * _uy, around = half * _spread, far = distance + around;
        away = Math.Max(Math.Abs(y * _ux - x * _uy), Math.Max(-along, along - _length)) - around;
        return _isUpright ? (From, To) : (Vec3.Lerp(From, To, Share(along - far)), Vec3.Lerp(From, To, Share(along + far)));
    }

    // True if an extrusion, at most so many mm above the tip, is clearly out of reach of the infinite line of the path.
    private readonly bool IsPassed(in Extrusion extrusion, double most)
    {
        if (_isUpright) return false;
        double ax = extrusion.Ax - From.X, ay = extrusion.Ay - From.Y, bx = extrusion.Bx - From.X, by = extrusion.By - From.Y;
        double aside = ay * _ux - ax * _uy, bside = by * _ux - bx * _uy;
        var level = From.Z + Tolerance;
        // Its ends above the slope of the path: it is as high above the tip there, or farther on as much more as the path falls.
        double a = extrusion.Az - level - _rise * (ax * _ux + ay * _uy), b = extrusion.Bz - level - _rise * (bx * _ux + by * _uy);
        double above = Math.Max(a, b), rise = Math.Abs(_rise);
        if (above + Head.Depth(rise, extrusion.Half, most, HitsOnly) <= -Same) return true;
        var reach = Head.Reach(most, extrusion.Half, HitsOnly);
        most = Math.Min(most, above + rise * reach);
        // It and the path lie in parallel planes.
        double across = (b - a) / (bside - aside), gradient = Math.Sqrt(across * across + _rise * _rise), under = a - across * aside;
        if (gradient < Steepest)
        {
            if (under + Head.Depth(gradient, extrusion.Half, most, HitsOnly) <= -Same) return true;
            most = Math.Min(most, under + gradient * reach);
        }
        reach = Head.Reach(most + Same, extrusion.Half, HitsOnly) + Same;
        return aside > 0 == bside > 0 && Math.Min(Math.Abs(aside), Math.Abs(bside)) > reach;
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
