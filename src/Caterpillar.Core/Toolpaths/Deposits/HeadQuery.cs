namespace Caterpillar.Toolpaths;

/// <summary>
/// A collision query for a head that moves straight from one point to another, also up or down. It records whether the head digs into something. It misses no
/// extrusion. A rise of less than 0.02 mm counts as level.
/// </summary>
internal struct HeadQuery
{
    // Rise of a piece that counts as level, and length of one that counts as straight up, mm.
    private const double Level = 0.02;
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

    // What is farther from the line of the path than (start + slope * height above it) / shrink is out of reach.
    private double _excess, _start, _slope, _shrink;
    private bool _addsHalf;

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

    /// <summary>Prepares for extrusions up to this many mm above the lowest tip.</summary>
    public void Aim(double excess)
    {
        _excess = excess;
        (_start, _slope, _addsHalf) = Head.LineAbove(excess, HitsOnly);
        var cut = _slope * _rise;
        _shrink = _isUpright || cut * cut >= 1 ? 0 : Math.Sqrt(1 - cut * cut);
    }

    /// <summary>
    /// True if an extrusion is clearly out of reach of the infinite line of the path. The sideways reach of the head grows with the height of the extrusion
    /// above the slope of the path.
    /// </summary>
    public readonly bool IsPassed(in Extrusion extrusion)
    {
        if (!(_shrink > 0)) return false;
        double ax = extrusion.Ax - From.X, ay = extrusion.Ay - From.Y, bx = extrusion.Bx - From.X, by = extrusion.By - From.Y;
        double aside = ay * _ux - ax * _uy, bside = by * _ux - bx * _uy;
        var level = From.Z + Tolerance;
        double a = extrusion.Az - level - _rise * (ax * _ux + ay * _uy), b = extrusion.Bz - level - _rise * (bx * _ux + by * _uy);
        var start = _addsHalf ? _start + extrusion.Half : _start;
        if (Math.Max(a, b) <= -Math.Abs(_rise) * (start + _slope * _excess) - Same) return true;
        if (Math.Abs(aside) * _shrink <= start + _slope * a + Same || Math.Abs(bside) * _shrink <= start + _slope * b + Same) return false;
        // It crosses the line.
        return aside > 0 == bside > 0 || start + _slope * (a + (b - a) * aside / (aside - bside)) < -Same;
    }

    /// <summary>True if the head hits. Digging is recorded.</summary>
    public bool Meets(in Extrusion extrusion)
    {
        if (IsPassed(extrusion)) return false;
        if (!HitsOnly && !Touches(extrusion, From, To, false)) return false;
        if (Touches(extrusion, From, To, true) && (!extrusion.IsSloped || TouchesSloped(extrusion))) return true;
        if (HitsOnly) return false;
        Digs = HitsOnly = true;
        Aim(_excess);
        return false;
    }

    /// <summary>Minimum distance of a square from the path, seen from above, mm. Negative if they may overlap.</summary>
    public readonly double DistanceTo(double x, double y, double half)
    {
        x -= From.X;
        y -= From.Y;
        var along = x * _ux + y * _uy;
        return Math.Max(Math.Abs(y * _ux - x * _uy), Math.Max(-along, along - _length)) - half * _spread;
    }

    /// <summary>Minimum height of the tip within some distance of such a square, mm.</summary>
    public readonly double LowestNear(double x, double y, double half, double distance)
    {
        if (_rise == 0) return Math.Min(From.Z, To.Z);
        var along = (x - From.X) * _ux + (y - From.Y) * _uy;
        var far = distance + half * _spread;
        return From.Z + _rise * Math.Min(_length, Math.Max(0, _rise > 0 ? along - far : along + far));
    }

    // An extrusion that goes up or down is level across itself. Where the path is over it, or beside it, the nearest of its points count; then its round ends.
    private readonly bool TouchesSloped(in Extrusion extrusion)
    {
        Vec3 a = From, b = To, first = new(extrusion.Ax, extrusion.Ay, extrusion.Az), last = new(extrusion.Bx, extrusion.By, extrusion.Bz);
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
            && Touches(Extrusion.At(end, end.Z, half), Vec3.Lerp(From, To, low), Vec3.Lerp(From, To, high), true);
    }

    private readonly bool Touches(in Extrusion extrusion, Vec3 a, Vec3 b, bool lenient)
    {
        var low = Math.Min(a.Z, b.Z) + Tolerance;
        if (Math.Abs(a.Z - b.Z) <= Level || (b - a).LengthXY <= Upright) return extrusion.Meets(a, b, low, Head, lenient);
        var reach = Head.AxisReach(extrusion.Top - low, extrusion.Half, lenient);
        if (!(reach >= 0) || extrusion.IsBeyond(a, b, reach)) return false;
        var (start, slope, addsHalf) = Head.LineAbove(extrusion.Top - low, lenient);
        if (addsHalf) start += extrusion.Half;
        var pass = new SlopePass(extrusion, a, b, Tolerance, slope);
        if (pass.Least > start + Same) return false;
        if (pass.Distance <= Head.AxisReach(pass.Excess + Same, extrusion.Half, lenient)) return true;
        // The reach is below the line there: shorter pieces have lower lines.
        var middle = Vec3.Lerp(a, b, 0.5);
        return Touches(extrusion, a, middle, lenient) || Touches(extrusion, middle, b, lenient);
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
