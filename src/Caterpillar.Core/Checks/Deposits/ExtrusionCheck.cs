namespace Caterpillar.Checks;

/// <summary>Extrusions in the air and their heights, and the contact area with the bed; passes on what must fit under the nozzle.</summary>
internal sealed class ExtrusionCheck(PrintSetup setup, PrintedSoFar printed, Findings findings)
{
    // Lengths in mm.
    public const double MostFree = 5;
    public const double MostBridge = 60;
    private const double Touch = 0.1;
    private const double SampleStep = 0.5;
    private const double ExactStep = 8;
    private const double FirstExact = 1;
    private const int MostSamples = 256;

    // An extrusion rests on another if about a seventh of its width does, as ends of infill on walls: farthest edge from its axis, as a part of its width
    // without the round sides.
    private const double FarthestEdge = 0.4;

    // Height over the root of the area on the bed.
    private const double Slenderest = 8;

    // Width in nozzles from which on it matters that material goes to the sides, and steps in which it is looked for.
    private const double Wide = 1.5;
    private const double Wider = 1.15;
    private readonly Printer _printer = setup.Printer;
    private readonly bool _isAsked = findings.LooksFor(Codes);
    private readonly FitCheck _fit = new(setup, printed, findings);
    private readonly BlobCheck _blobs = new(setup, printed, findings);
    private readonly Kinematics? _kinematics = setup.Printer.Kinematics;
    private readonly double _usualHeight = setup.Settings.LargerLayerHeight;
    private Vec3 _start, _end;
    private bool _isOpen, _anchored, _startsHeld, _hasLanded;
    private double _air, _sinceExact;
    private (int Index, Role Role) _airMove;
    private double _length, _volume, _sinceGap, _gap;
    private double _standing, _highest;

    /// <summary>Codes of its findings.</summary>
    public static IReadOnlyList<string> Codes { get; } =
    [
        CheckCodes.Unsupported, CheckCodes.Duplicate, CheckCodes.Squeezed, CheckCodes.Blob, CheckCodes.TooLow, CheckCodes.Width, CheckCodes.Height,
            CheckCodes.InAir, CheckCodes.FirstLayer,
    ];

    /// <summary>True after the first extrusions have touched something, or are reported.</summary>
    public bool HasBegun => _hasLanded;

    /// <summary>An extrusion along a straight move; its nominal height and the height that it fills, mm.</summary>
    public (double Nominal, double Filled) Extrusion(in CheckedMove move)
    {
        if (move.Start != _end) Break();
        if (!_isOpen) (_isOpen, _start) = (true, move.Start);
        _end = move.End;
        var area = AreaOf(move);
        // Layers much thicker or thinner than their extrusions say nothing about them: files without comments about layers, drawings.
        var known = area >= 0.5 * move.Thickness * move.Thickness && area <= FitCheck.Widest * _printer.NozzleDiameter * move.Thickness;
        if (_kinematics is not null && _kinematics.Direction(move.EndTurns) is var tool && tool != Vec3.UnitZ)
            return Leaning(move, tool, known ? move.Thickness : 0, area);
        // Where nothing is looked for, others still need the heights.
        if (known && !_isAsked) return (move.Thickness, move.Thickness);
        var nominal = known ? move.Thickness : _usualHeight;
        // On curved layers extrusions may be much thinner than their layer says: what they lie on is nearer, then.
        var least = Math.Min(nominal, area / _printer.NozzleDiameter);
        var own = known ? nominal : GapUnder(move, area, least);
        var count = (int)Math.Min(Math.Ceiling(move.Length / SampleStep), MostSamples);
        var step = move.Length / count;
        var reach = 2 * Math.Max(nominal, _printer.NozzleDiameter / 2) + Touch;
        var beside = FarthestEdge * area / own;
        var gap = double.NaN;
        var tight = double.PositiveInfinity;
        var nearest = double.PositiveInfinity;
        for (var k = 0; k < count; k++)
        {
            var p = Vec3.Lerp(move.Start, move.End, (k + 0.5) / count);
            var floor = printed.FloorUnder(p);
            var (top, under) = printed.Deposit.CellAt(p.X, p.Y);
            gap = Gap(p.Z, top, under, floor, nominal);
            tight = Math.Min(tight, gap);
            nearest = Math.Min(nearest, p.Z - floor);
            // The gap of a thinner extrusion is never larger.
            var isHeld = gap <= reach || Gap(p.Z, top, under, floor, least) <= reach;
            _sinceExact += step;
            // Cells are wider than what is in them.
            if (p.Z - floor > reach && (!isHeld || _sinceExact > ExactStep || _air > 0))
            {
                isHeld = printed.Deposit.TopUnder(p, p.Z - 0.5 * least, beside, least: p.Z - reach) >= p.Z - reach;
                if (isHeld) _sinceExact = 0;
            }
            if (isHeld || move.Role == Role.Purge) Land(move);
            else Fly(move, step);
            if (gap == p.Z - floor) Stand(move, gap, reach, step * area, nominal);
        }
        _highest = Math.Max(_highest, Math.Max(move.Start.Z, move.End.Z));
        var height = known ? move.Thickness : Math.Max(0, Math.Min(gap, nominal));
        if (move.Role == Role.Purge)
        {
            _fit.Purged(move);
            return (height, height);
        }
        // An extrusion is as high as its gap, or round where it hangs; layers of drawings may be much thinner than that.
        var filled = Math.Max(height, known ? Math.Min(tight, Round(area)) : own);
        _fit.Look(move, area, height, filled, known, nearest);
        return (height, known ? height : filled);
    }

    // Of a tool that leans: what lies below it along the tool holds it.
    private (double Nominal, double Filled) Leaning(in CheckedMove move, Vec3 tool, double thickness, double area)
    {
        var nominal = thickness > 0 ? thickness : _usualHeight;
        var reach = 2 * Math.Max(nominal, _printer.NozzleDiameter / 2) + Touch;
        // What is about as high is next to it. The extrusion may be much thinner than its layer.
        var beside = 0.3 * Math.Min(nominal, area / _printer.NozzleDiameter);
        var count = (int)Math.Min(Math.Ceiling(move.Length / SampleStep), MostSamples);
        var height = nominal;
        for (var k = 0; k < count; k++)
        {
            var p = Vec3.Lerp(move.Start, move.End, (k + 0.5) / count);
            var below = printed.Strands!.Below(p - tool * beside, tool, reach - beside, exactly: !(thickness > 0));
            if (below <= reach - beside || move.Role == Role.Purge) Land(move);
            else Fly(move, move.Length / count);
            Stand(move, p.Z - printed.FloorUnder(p), nominal, move.Length / count * area, nominal);
            if (!(thickness > 0)) height = Math.Min(height, beside + below);
        }
        _highest = Math.Max(_highest, Math.Max(move.Start.Z, move.End.Z));
        return (height, height);
    }

    // The area on the bed or the object of a volume at a height above it.
    private void Stand(in CheckedMove move, double height, double most, double volume, double nominal)
    {
        if (height <= most && move.Role is not (Role.Skirt or Role.Purge)) _standing += volume / Math.Max(height, nominal / 2);
    }

    /// <summary>Material in place.</summary>
    public void Blob(in CheckedMove move) => _blobs.Look(move, _highest == 0);

    /// <summary>The head moves on without printing.</summary>
    public void Break()
    {
        // A loop ends next to its start, which holds it if it has something below it.
        var isHeld = _startsHeld && _end.DistanceTo(_start) <= _printer.NozzleDiameter;
        if (_air > (isHeld ? MostBridge : MostFree)) ReportAir(isHeld);
        _air = _length = _volume = 0;
        _sinceGap = double.MaxValue;
        // The ends of paths touch others; short ones may be in the air.
        _sinceExact = ExactStep - FirstExact;
        _isOpen = _anchored = _startsHeld = false;
        _fit.Break();
    }

    public void End()
    {
        Break();
        var slender = _highest / Math.Sqrt(_standing);
        if (_standing > 0 && slender > Slenderest)
            findings.Add(CheckCodes.FirstLayer, () => null,
                () => $"The print is {NumberFormatter.Format(_highest, 2)} mm high, but only {NumberFormatter.Format(_standing, 0)} mm² of it touch the bed. "
                    + "Add a brim.");
    }

    private static double Round(double area) => 2 * Math.Sqrt(area / Math.PI);

    // mm to the bed or to an extrusion below; anything about as high as the extrusion itself is next to it.
    private static double Gap(double z, double top, double under, double floor, double height)
    {
        var highest = z - 0.5 * height;
        var below = top <= highest ? top : under <= highest ? under : 0;
        return z - (below > floor ? below : floor);
    }

    // E and positions are rounded: the cross-section of very short moves is that of several.
    private double AreaOf(in CheckedMove move)
    {
        if (move.Length >= SampleStep)
        {
            _length = _volume = 0;
            return move.Deposited / move.Length;
        }
        if (_length > SampleStep) (_length, _volume) = (_length / 2, _volume / 2);
        _length += move.Length;
        _volume += move.Deposited;
        return _volume / _length;
    }

    // The height that an extrusion fills, mm: down to what is below its middle, or less where that is near and material goes to the sides.
    private double GapUnder(in CheckedMove move, double area, double least)
    {
        _sinceGap += move.Length;
        if (_sinceGap < SampleStep) return Math.Min(_gap, Round(area));
        _sinceGap = 0;
        var middle = Vec3.Lerp(move.Start, move.End, 0.5);
        // What is about as high is next to it.
        _gap = printed.GapBelow(middle, least / 2, out var below);
        if (area > Wide * _printer.NozzleDiameter * _gap) _gap = area / WidthOver(middle, move.End - move.Start, area, least, below);
        return Math.Min(_gap, Round(area));
    }

    // The width in which it has room above the extrusion below its middle and those beside that.
    private double WidthOver(Vec3 middle, Vec3 along, double area, double least, Extrusion? below)
    {
        var round = Round(area);
        var (width, most) = (area / round, PrintedSoFar.Widest * _printer.NozzleDiameter);
        var across = along.LengthXY > 0 ? new Vec3(-along.Y, along.X) / along.LengthXY : Vec3.Zero;
        while (width < most && Mean(width) * width < area) width *= Wider;
        return Math.Min(width, most);

        // The mean gap; one that is clearly too small need not be exact.
        double Mean(double over) => printed.GapAcross(middle, across * (over / 2), round, middle.Z - least / 2, int.MaxValue, area / over, below);
    }

    private void Fly(in CheckedMove move, double step)
    {
        if (_air == 0) _airMove = (move.Index, move.Role);
        _air += step;
    }

    private void Land(in CheckedMove move)
    {
        if (_air > (_anchored ? MostBridge : MostFree)) ReportAir(_anchored);
        _hasLanded |= move.Role != Role.Purge;
        _startsHeld |= !_anchored && _air == 0;
        _air = 0;
        _anchored = true;
    }

    private void ReportAir(bool bridge)
    {
        var air = _air;
        if (!_hasLanded)
        {
            findings.Add(CheckCodes.InAir, _airMove.Index, () => $"The print begins in the air: its first {NumberFormatter.Format(air, 1)} mm touch neither "
                + "the bed nor an object. Lower the print.");
            _hasLanded = true;
        }
        var (what, remedy) = _airMove.Role is Role.Support or Role.SupportInterface
            ? ("A support", "Use denser supports, or a grid instead of trees.") : ("An extrusion", "Add supports below it.");
        findings.Add(CheckCodes.Unsupported, _airMove.Index, () => $"{what} is in the air for {NumberFormatter.Format(air, 1)} mm, "
            + (bridge ? "between two supports. " : "with a free end. ") + remedy, air);
    }
}
