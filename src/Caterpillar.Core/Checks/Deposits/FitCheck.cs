namespace Caterpillar.Checks;

/// <summary>
/// Whether extrusions fit into the gap under the nozzle: above the bed, the object and what is solid, and in the place of earlier extrusions. What was printed
/// in the same layer is still soft and moves aside.
/// </summary>
internal sealed class FitCheck
{
    // Lengths in mm.
    public const double MostOdd = 5;
    public const double MostDoubled = 20;
    private const double ShortestLook = 0.5;

    private const double Flat = 0.002;

    // Gaps below the nozzle, as parts of the height of the extrusion.
    private const double TooLow = 0.3;
    private const double Tight = 0.6;
    private const double Climbs = 0.02;

    // In nozzles.
    public const double Widest = 3;
    private const double Thinnest = 0.2;
    private readonly Printer _printer;
    private readonly PrintedSoFar _printed;
    private readonly Findings _findings;
    private readonly BeadShape _shape;
    private readonly double _usualHeight;
    private readonly bool _looksForDoubled, _looksForNear;

    // The first move of each layer.
    private readonly List<int> _firstOf = [];
    private int _firstPrint = -1, _layer = -1;
    private double _height, _heightBefore, _purgedUpTo, _solidGap;
    private double _doubled, _sinceLook;
    private int _doubledMove;
    private OddLength _wide, _thin, _low, _tight, _solidLow, _solidTight, _primeLow;

    public FitCheck(PrintSetup setup, PrintedSoFar printed, Findings findings)
    {
        (_printer, _printed, _findings) = (setup.Printer, printed, findings);
        _shape = setup.Settings.BeadShape;
        _usualHeight = setup.Settings.LargerLayerHeight;
        _looksForDoubled = findings.LooksFor([CheckCodes.Duplicate]);
        _looksForNear = findings.LooksFor([CheckCodes.TooLow, CheckCodes.Squeezed]);
    }

    /// <summary>The head moves on without printing.</summary>
    public void Break() => _doubled = _sinceLook = _solidLow.Length = _solidTight.Length = 0;

    /// <summary>What is purged before the first extrusion is there.</summary>
    public void Purged(in CheckedMove move)
    {
        if (_firstPrint < 0) _purgedUpTo = Math.Max(_purgedUpTo, Math.Max(move.Start.Z, move.End.Z));
    }

    /// <summary>An extrusion along a straight move.</summary>
    /// <param name="move">The move.</param>
    /// <param name="area">Its cross-section, mm².</param>
    /// <param name="height">Its height, mm, as its layer says, or else as what it lies on says.</param>
    /// <param name="highest">The height that it fills, mm.</param>
    /// <param name="isKnown">True if its layer says its height.</param>
    /// <param name="nearest">The smallest gap to the bed or object, mm.</param>
    public void Look(in CheckedMove move, double area, double height, double highest, bool isKnown, double nearest)
    {
        if (_firstPrint < 0) _firstPrint = move.Index;
        Dimensions(move, area, height, highest, isKnown);
        if (move.Role == Role.Ironing) return;
        // On curved layers extrusions may be much thinner than their layer says: what they lie on is nearer, then.
        var least = Math.Min(area / _printer.NozzleDiameter, Math.Max(height, _usualHeight));
        if (nearest < TooLow * least)
        {
            if (_low.Add(move) is { } at) ReportNear(CheckCodes.TooLow, at, nearest, least, -1);
        }
        else if (nearest < Tight * least && _tight.Add(move) is { } at)
        {
            ReportNear(CheckCodes.Squeezed, at, nearest, least, -1);
        }
        if (move.Role is not (Role.GapFill or Role.PrimeTower)) Overlaps(move, area, height, isKnown);
    }

    private static string Number(double value) => NumberFormatter.Format(value, 2);

    private void Dimensions(in CheckedMove move, double area, double height, double highest, bool isKnown)
    {
        if (isKnown && height > _printer.NozzleDiameter * 1.001) ReportHeight(move.Index, height);
        var (width, least) = (new Bead(area, height).Width(_shape), new Bead(area, highest).Width(_shape));
        if (least > Widest * _printer.NozzleDiameter * 1.001)
        {
            if (_wide.Add(move) is { } at) ReportWidth(at, least);
        }
        else if (width < Thinnest * _printer.NozzleDiameter && move.Role is not (Role.Ironing or Role.GapFill))
        {
            // Ramps of seams run out over each other, thinner and thinner.
            width = new Bead(area, Math.Min(height, _printed.GapBelow(Vec3.Lerp(move.Start, move.End, 0.5), Flat, out _))).Width(_shape);
            if (width < Thinnest * _printer.NozzleDiameter && _thin.Add(move) is { } at) ReportWidth(at, width);
        }
    }

    // Reports are apart from what they are about, which would allocate what they capture for each move.
    private void ReportHeight(int move, double height)
        => _findings.Add(CheckCodes.Height, move,
            () => $"A layer is {Number(height)} mm high, more than the nozzle diameter of {Number(_printer.NozzleDiameter)} mm. Lower it.", height);

    private void ReportWidth(int move, double width)
        => _findings.Add(CheckCodes.Width, move, () => $"Extrusions are {Number(width)} mm wide, too {(width > _printer.NozzleDiameter ? "wide" : "narrow")} "
            + $"for a nozzle of {Number(_printer.NozzleDiameter)} mm. Check line width and flow ratio.",
            width > _printer.NozzleDiameter ? width / (Widest * _printer.NozzleDiameter) : Thinnest * _printer.NozzleDiameter / width);

    private void ReportNear(string code, int move, double gap, double height, int other)
        => _findings.AddNaming(code, move, () =>
        {
            var floor = _printed.Object is null ? "bed" : "bed or the object";
            return () => $"The nozzle is {Number(gap)} mm above the {(other < 0 ? floor : "earlier extrusion" + By(other))}, but the extrusion is "
                + $"{Number(height)} mm high. "
                + (other >= 0 && other < _firstPrint ? "Move the model, or move the prime line in the start G-code of the printer."
                    : $"Raise the path by {Number(height - gap)} mm.");
        }, height - gap);

    private string By(int other) => (other < _firstPrint ? " of the start G-code" : "") + _findings.InBrackets(other);

    // In the place of earlier extrusions, along them or across them.
    private void Overlaps(in CheckedMove move, double area, double height, bool isKnown)
    {
        if (!_looksForDoubled && !_looksForNear) return;
        var solid = Solid(move);
        // Several short moves have one look.
        _sinceLook += move.Length;
        if (_sinceLook < ShortestLook) return;
        var total = _sinceLook;
        _sinceLook = 0;
        var thickness = Math.Min(area / _printer.NozzleDiameter, height);
        // A layer that is thinner than the one before may be only too near.
        var least = Math.Min(area / _printer.NozzleDiameter, isKnown ? Math.Min(Math.Max(height, _heightBefore), _printer.NozzleDiameter) : _usualHeight);
        var half = new Bead(area, height).Width(_shape) / 2;
        var along = move.End - move.Start;
        // A line of the start code is narrow.
        var isNearPurged = Math.Min(move.Start.Z, move.End.Z) < _purgedUpTo + Tight * least;
        var count = (int)(isNearPurged ? Math.Min(Math.Ceiling(2 * move.Length), 256) : Math.Min(Math.Ceiling(move.Length), 16));
        // Without layers, what is as high as the path belongs to it.
        var gaps = (move.Layer < 0 ? Flat : -least / 2, Tight * least);
        for (var k = 0; k < count; k++)
        {
            var p = Vec3.Lerp(move.Start, move.End, (k + 0.5) / count);
            var overlap = _printed.Deposit.Overlaps.At(p, along, half, thickness, gaps, solid, out var other);
            var step = total / count;
            if (overlap == DepositOverlap.None)
            {
                Break();
                continue;
            }
            if ((overlap & DepositOverlap.Solid) == 0) _solidLow.Length = _solidTight.Length = 0;
            else OnSolid(move.Index, step, p, along, area, least, solid, other);
            if ((overlap & DepositOverlap.Parallel) == 0) _doubled = 0;
            else Doubled(move.Index, step, other);
        }
    }

    // Extrusions with a lower number are solid: those of the layers before, and of the start code.
    private int Solid(in CheckedMove move)
    {
        if (move.Layer < 0) return move.Index;
        if (move.Layer != _layer) (_layer, _heightBefore, _height) = (move.Layer, _height, move.Thickness);
        while (_firstOf.Count <= move.Layer) _firstOf.Add(-1);
        if (_firstOf[move.Layer] < 0) _firstOf[move.Layer] = move.Index;
        return Math.Max(_firstOf[move.Layer], _firstPrint);
    }

    private void OnSolid(int move, double step, Vec3 p, Vec3 along, double area, double least, int solid, int other)
    {
        var across = new Vec3(-along.Y, along.X) / along.LengthXY;
        var gap = _printed.GapAcross(p, across * (area / least / 2), 2 * Math.Sqrt(area / Math.PI), p.Z + least / 2, solid);
        // The first turn of a helix climbs out.
        if (Math.Abs(gap - _solidGap) > Climbs * least)
        {
            _solidGap = gap;
            _solidLow.Length = _solidTight.Length = 0;
        }
        if (gap < TooLow * least)
        {
            ref var low = ref _solidLow;
            if (other < _firstPrint) low = ref _primeLow;
            if (low.Add(move, step) is { } at) ReportNear(CheckCodes.TooLow, at, gap, least, other);
        }
        else
        {
            _solidLow.Length = 0;
            if (!(gap < Tight * least)) _solidTight.Length = 0;
            else if (_solidTight.Add(move, step) is { } at) ReportNear(CheckCodes.Squeezed, at, gap, least, other);
        }
    }

    private void Doubled(int move, double step, int other)
    {
        var before = _doubled;
        if (before == 0) _doubledMove = move;
        _doubled += step;
        // Once for each run.
        if (_looksForDoubled && before <= MostDoubled && _doubled > MostDoubled) ReportDoubled(_doubledMove, other);
    }

    private void ReportDoubled(int move, int other)
        => _findings.AddNaming(CheckCodes.Duplicate, move, () => () => "Extrusions are in the same place as earlier ones"
            + _findings.InBrackets(other) + ". Remove the duplicates.");

    // A length of what is odd, and the move where it begins.
    private struct OddLength
    {
        public double Length;
        private int _first, _last;

        public int? Add(in CheckedMove move) => Add(move.Index, move.Length);

        /// <summary>The move to report as soon as more than a little is odd: the first one, then each once; null before.</summary>
        public int? Add(int move, double length)
        {
            if (Length == 0) _first = move;
            var (before, isNext) = (Length, move != _last);
            Length += length;
            if (Length <= MostOdd) return null;
            _last = move;
            return before <= MostOdd ? _first : isNext ? move : null;
        }
    }
}
