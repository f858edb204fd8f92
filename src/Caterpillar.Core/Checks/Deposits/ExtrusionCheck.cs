using Caterpillar.Geometry;
using Caterpillar.Machines;
using Caterpillar.Toolpaths;

namespace Caterpillar.Checks;

/// <summary>Extrusions in the air, duplicate, too thick for their gap or for the nozzle, and the contact area with the bed.</summary>
internal sealed class ExtrusionCheck
{
    // Lengths in mm.
    public const double MostFree = 5;
    public const double MostBridge = 60;
    public const double MostOdd = 5;
    public const double MostDoubled = 20;
    private const double Touch = 0.1;
    private const double Flat = 0.002;
    private const double SampleStep = 0.5;
    private const int MostSamples = 256;

    // Gaps below the nozzle, as parts of the height of the bead.
    private const double TooLow = 0.3;
    private const double Tight = 0.6;

    // In nozzles.
    private const double Widest = 3;
    private const double Thinnest = 0.2;
    private const double WidestSqueezed = 4;
    private const double WidestBlob = 10;
    private const double RefusedBlob = 20;

    // Height over the root of the area on the bed.
    private const double Slenderest = 8;
    private readonly Printer _printer;
    private readonly bool _isAsked, _looksForDoubled;
    private readonly PrintedSoFar _printed;
    private readonly Findings _findings;
    private readonly BeadShape _shape;
    private readonly double _usualHeight;
    private Vec3 _start, _end;
    private bool _isOpen, _anchored, _startsHeld;
    private double _air;
    private int _airMove;
    private double _wide, _thin, _doubled, _low, _tight;
    private int _wideMove, _thinMove, _doubledMove, _lowMove, _tightMove;
    private double _standing, _highest;

    public ExtrusionCheck(PrintSetup setup, PrintedSoFar printed, Findings findings)
    {
        _printer = setup.Printer;
        _printed = printed;
        _findings = findings;
        (_isAsked, _looksForDoubled) = (findings.LooksFor(Codes), findings.LooksFor([CheckCodes.Duplicate]));
        _shape = setup.Settings.BeadShape;
        _usualHeight = Math.Max(setup.Settings.LayerHeight, setup.Settings.FirstLayerHeight);
    }

    /// <summary>Codes of its findings.</summary>
    public static IReadOnlyList<string> Codes { get; } =
    [
        CheckCodes.Unsupported, CheckCodes.Duplicate, CheckCodes.Squeezed, CheckCodes.Blob, CheckCodes.TooLow, CheckCodes.Width, CheckCodes.Height,
            CheckCodes.FirstLayer,
    ];

    /// <summary>An extrusion along a straight move; its nominal height and the height that it fills, mm.</summary>
    public (double Nominal, double Filled) Extrusion(in CheckedMove move)
    {
        if (move.Start != _end) Break();
        if (!_isOpen) (_isOpen, _start) = (true, move.Start);
        _end = move.End;
        var area = move.Deposited / move.Length;
        // Layers much thicker or thinner than their extrusions say nothing about them: files without comments about layers, drawings.
        var known = area >= 0.5 * move.Thickness * move.Thickness && area <= PrintedSoFar.Widest * _printer.NozzleDiameter * move.Thickness;
        // Where nothing is looked for, others still need the heights.
        if (known && !_isAsked) return (move.Thickness, move.Thickness);
        var nominal = known ? move.Thickness : _usualHeight;
        // On curved layers extrusions may be much thinner than their layer says: what they lie on is nearer, then.
        var least = Math.Min(nominal, area / _printer.NozzleDiameter);
        var count = (int)Math.Min(Math.Ceiling(move.Length / SampleStep), MostSamples);
        var step = move.Length / count;
        var reach = 2 * Math.Max(nominal, _printer.NozzleDiameter / 2) + Touch;
        var gap = double.NaN;
        var tight = double.PositiveInfinity;
        var nearest = double.PositiveInfinity;
        for (var k = 0; k < count; k++)
        {
            var p = Vec3.Lerp(move.Start, move.End, (k + 0.5) / count);
            var floor = _printed.FloorUnder(p);
            var (top, under) = _printed.Deposit.CellAt(p.X, p.Y);
            gap = Gap(p.Z, top, under, floor, nominal);
            tight = Math.Min(tight, gap);
            nearest = Math.Min(nearest, p.Z - floor);
            // The gap of a thinner extrusion is never larger.
            if (gap <= reach || Gap(p.Z, top, under, floor, least) <= reach || move.Role == Role.Purge) Land(move.Index);
            else Fly(move.Index, step);
            if (gap == p.Z - floor && gap <= reach
                && move.Role is not (Role.Skirt or Role.Purge)) _standing += step * area / Math.Max(gap, nominal / 2);
        }
        _highest = Math.Max(_highest, Math.Max(move.Start.Z, move.End.Z));
        var height = known ? move.Thickness : Math.Max(0, Math.Min(gap, nominal));
        // An extrusion is as high as its gap, or round where it hangs; layers of drawings may be much thinner than that.
        var filled = Math.Max(height, Math.Min(tight, 2 * Math.Sqrt(area / Math.PI)));
        if (move.Role == Role.Purge) return (height, height);
        Dimensions(move, area, height, filled, known);
        if (move.Role != Role.Ironing) Closeness(move, nearest, least);
        if (tight > 0 && area / tight > WidestSqueezed * _printer.NozzleDiameter) Squeezed(move, area, tight);
        if (_looksForDoubled && move.Role is not (Role.Ironing or Role.GapFill or Role.PrimeTower)) Doubles(move, area, height);
        return (height, known ? height : filled);
    }

    /// <summary>Material in place.</summary>
    public void Blob(in CheckedMove move)
    {
        var gap = GapBelow(move.End, Math.Min(_usualHeight, move.End.Z));
        // Higher up it hangs from the nozzle.
        if (gap > _printer.NozzleDiameter || (_highest == 0 && move.Role == Role.Purge)) return;
        var volume = move.Deposited;
        var width = 2 * Math.Sqrt(volume / (Math.PI * Math.Max(gap, Flat)));
        if (width > RefusedBlob * _printer.NozzleDiameter) ReportBlob(move.Index, volume, gap, width);
        if (!(gap > 0) || _highest == 0 || !(width > WidestBlob * _printer.NozzleDiameter)) return;
        _findings.Add(CheckCodes.Squeezed, move.Index, () => $"{Number(volume)} mm³ extruded in place do not fit into the {Number(gap)} mm under the nozzle: "
            + $"the blob would be {Number(width)} mm wide. Extrude less.", width);
    }

    /// <summary>The head moves on without printing.</summary>
    public void Break()
    {
        // A loop ends next to its start, which holds it if it has something below it.
        var isHeld = _startsHeld && _end.DistanceTo(_start) <= _printer.NozzleDiameter;
        if (_air > (isHeld ? MostBridge : MostFree)) ReportAir(isHeld);
        _air = _doubled = 0;
        _isOpen = _anchored = _startsHeld = false;
    }

    public void End()
    {
        Break();
        var slender = _highest / Math.Sqrt(_standing);
        if (_standing > 0 && slender > Slenderest)
            _findings.Add(CheckCodes.FirstLayer, () => null,
                () => $"The print is {Number(_highest)} mm high, but only {NumberFormatter.Format(_standing, 0)} mm² of it touch the bed. Add a brim.");
    }

    private static string Number(double value) => NumberFormatter.Format(value, 2);

    private double GapBelow(Vec3 p, double height)
    {
        var (top, under) = _printed.Deposit.CellAt(p.X, p.Y);
        return Gap(p.Z, top, under, _printed.FloorUnder(p), height);
    }

    // mm to the bed or to an extrusion below; anything about as high as the extrusion itself is next to it.
    private static double Gap(double z, double top, double under, double floor, double height)
    {
        var highest = z - 0.5 * height;
        var below = top <= highest ? top : under <= highest ? under : 0;
        return z - (below > floor ? below : floor);
    }

    // mm to what lies exactly below the middle of an extrusion: ramps of seams run out over each other, thinner and thinner.
    private double OwnGap(in CheckedMove move)
    {
        var middle = Vec3.Lerp(move.Start, move.End, 0.5);
        var below = Math.Max(_printed.Deposit.TopUnder(middle, middle.Z - Flat), _printed.FloorUnder(middle));
        return middle.Z > below ? middle.Z - below : double.MaxValue;
    }

    private void Fly(int move, double step)
    {
        if (_air == 0) _airMove = move;
        _air += step;
    }

    private void Land(int move)
    {
        if (_air > (_anchored ? MostBridge : MostFree)) ReportAir(_anchored);
        _startsHeld |= !_anchored && _air == 0;
        _air = 0;
        _anchored = true;
    }

    private void ReportAir(bool bridge)
    {
        var air = _air;
        _findings.Add(CheckCodes.Unsupported, _airMove, () => $"An extrusion is in the air for {NumberFormatter.Format(air, 1)} mm, "
            + (bridge ? "between two supports. Add supports below it." : "with a free end. Add supports below it."), air);
    }

    private void Dimensions(in CheckedMove move, double area, double height, double highest, bool known)
    {
        if (known && height > _printer.NozzleDiameter * 1.001) ReportHeight(move.Index, height);
        var (width, least) = (new Bead(area, height).Width(_shape), new Bead(area, highest).Width(_shape));
        if (least > Widest * _printer.NozzleDiameter * 1.001)
        {
            if (Odd(ref _wide, ref _wideMove, move) is { } at) ReportWidth(at, least);
        }
        else if (width < Thinnest * _printer.NozzleDiameter && move.Role is not (Role.Ironing or Role.GapFill))
        {
            width = new Bead(area, Math.Min(height, OwnGap(move))).Width(_shape);
            if (width < Thinnest * _printer.NozzleDiameter && Odd(ref _thin, ref _thinMove, move) is { } at) ReportWidth(at, width);
        }
    }

    // Reports are apart from what they are about, which would allocate what they capture for each move.
    private void ReportHeight(int move, double height)
        => _findings.Add(CheckCodes.Height, move,
            () => $"A layer is {Number(height)} mm high, more than the nozzle diameter of {Number(_printer.NozzleDiameter)} mm. Lower it.", height);

    // The move to report as soon as more than a little is odd: the first one, then each; null before.
    private static int? Odd(ref double length, ref int first, in CheckedMove move)
    {
        if (length == 0) first = move.Index;
        var before = length;
        length += move.Length;
        return length <= MostOdd ? null : before > MostOdd ? move.Index : first;
    }

    private void ReportWidth(int move, double width)
        => _findings.Add(CheckCodes.Width, move, () => $"Extrusions are {Number(width)} mm wide, too {(width > _printer.NozzleDiameter ? "wide" : "narrow")} "
            + $"for a nozzle of {Number(_printer.NozzleDiameter)} mm. Check line width and flow ratio.",
            width > _printer.NozzleDiameter ? width / (Widest * _printer.NozzleDiameter) : Thinnest * _printer.NozzleDiameter / width);

    private void Closeness(in CheckedMove move, double gap, double height)
    {
        if (gap < TooLow * height)
        {
            if (Odd(ref _low, ref _lowMove, move) is { } at) ReportNear(CheckCodes.TooLow, at, gap, height);
        }
        else if (gap < Tight * height && Odd(ref _tight, ref _tightMove, move) is { } at)
        {
            ReportNear(CheckCodes.Squeezed, at, gap, height);
        }
    }

    private void ReportNear(string code, int move, double gap, double height)
        => _findings.Add(code, move, () => $"The nozzle is {Number(gap)} mm above the bed{(_printed.Object is null ? "" : " or the object")}, but the "
            + $"extrusion is {Number(height)} mm high. Raise the path by {Number(height - gap)} mm.", height - gap);

    private void ReportBlob(int move, double volume, double gap, double width)
        => _findings.Add(CheckCodes.Blob, move, () => $"{Number(volume)} mm³ extruded in place with the nozzle {Number(gap)} mm above the bed "
            + $"or the print make a blob {Number(width)} mm wide. Extrude less, or raise the nozzle first.", width);

    private void Squeezed(in CheckedMove move, double area, double gap)
        => _findings.Add(CheckCodes.Squeezed, move.Index,
            () => $"An extrusion of {Number(area)} mm² does not fit into the {Number(gap)} mm under the nozzle: it would be "
            + $"{Number(area / gap)} mm wide. Extrude less.", area / gap);

    private void Doubles(in CheckedMove move, double area, double height)
    {
        var half = new Bead(area, height).Width(_shape) / 2;
        // Thin extrusions above each other are not in each other's place.
        var thickness = Math.Min(height, area / _printer.NozzleDiameter);
        var count = (int)Math.Min(Math.Ceiling(move.Length), 16);
        for (var k = 0; k < count; k++)
        {
            var p = Vec3.Lerp(move.Start, move.End, (k + 0.5) / count);
            if (!_printed.Deposit.HasParallel(p, move.End - move.Start, half, thickness, out var other))
            {
                _doubled = 0;
                continue;
            }
            var before = _doubled;
            if (before == 0) _doubledMove = move.Index;
            _doubled += move.Length / count;
            // Once for each run.
            if (before <= MostDoubled && _doubled > MostDoubled) ReportDoubled(_doubledMove, other);
        }
    }

    private void ReportDoubled(int move, int other)
        => _findings.AddNaming(CheckCodes.Duplicate, move, () => () => "Extrusions are in the same place as earlier ones"
            + (other >= 0 && _findings.PlaceOf(other) is { } place ? $" ({place with { Origin = null, Step = null }})" : "") + ". Remove the duplicates.");
}
