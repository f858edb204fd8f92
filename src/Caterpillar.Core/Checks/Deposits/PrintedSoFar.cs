namespace Caterpillar.Checks;

/// <summary>
/// Earlier extrusions, without the fresh end of the current one, which the nozzle always touches. Extrusions have the numbers of their moves.
/// </summary>
internal sealed class PrintedSoFar
{
    /// <summary>Widest extrusion, in nozzles.</summary>
    public const double Widest = 12;

    /// <summary>Tags of strands that are no extrusions: the object, the bed, and from the last one downward the clips.</summary>
    public const int ObjectTag = -1, BedTag = -2, ClipTag = -3;

    // Only what is about as high as the tip is asked for exactly; in cells.
    private const double KeepDepth = 24;

    // Where a mean gap is measured across a path.
    private const int Places = 8;
    private readonly double[] _known = new double[Places];
    private readonly BeadShape _shape;
    private readonly double _widest;
    private readonly Kinematics? _kinematics;

    // What is fresh, from the oldest piece up to the newest.
    private Fresh[] _fresh = new Fresh[64];
    private int _oldest, _newest;
    private double _distance;

    /// <param name="setup">The head, the shape of extrusions and the object below the print.</param>
    public PrintedSoFar(PrintSetup setup)
    {
        var printer = setup.Printer;
        if (setup.PrintedOn is { } mesh) Object = new ObjectTop(mesh, CellOf(printer));
        _kinematics = printer.Kinematics;
        Head = new HeadShape(Outline(printer));
        _shape = setup.Settings.BeadShape;
        _widest = Widest * printer.NozzleDiameter;
        Deposit = new Deposit(CellOf(printer), KeepDepth * CellOf(printer));
        if (_kinematics is not null) Strands = Around(setup);
        Lag = Head.FlatRadius + printer.NozzleDiameter + 2 * Deposit.Cell;
    }

    public Deposit Deposit { get; }

    /// <summary>The same in space, for a head that leans; null for printers without rotary axes.</summary>
    public StrandGrid? Strands { get; }

    /// <summary>The object below the print; null = none.</summary>
    public ObjectTop? Object { get; }

    /// <summary>Highest printed point, mm, including fresh extrusions.</summary>
    public double Highest { get; private set; } = double.NegativeInfinity;

    public HeadShape Head { get; }

    /// <summary>Length of motion after which an extrusion is no longer fresh, mm.</summary>
    public double Lag { get; }

    /// <summary>In so many pieces an extrusion stops to be fresh.</summary>
    public const int FreshPieces = 2;

    /// <summary>Length of such a piece, mm.</summary>
    public double FreshPiece => Lag / FreshPieces;

    /// <summary>Side of the cells for a printer, mm.</summary>
    public static double CellOf(Printer printer) => Math.Max(0.25, printer.NozzleDiameter / 4);

    /// <summary>Height of the object or of the bed below a point of a path, mm. Extrusions may be pressed into it a little.</summary>
    public double FloorUnder(Vec3 p) => Object is null ? 0 : Math.Max(0, Math.Min(p.Z, Object.Under(p.X, p.Y, p.Z + CollisionCheck.Flush)));

    /// <summary>
    /// Gap of at least <paramref name="least"/> mm between a point of a path and what lies exactly below it, mm, and the extrusion there. Null = none.
    /// </summary>
    public double GapBelow(Vec3 p, double least, out Extrusion? extrusion)
    {
        var below = Math.Max(Deposit.TopUnder(p, p.Z - least, out extrusion), FloorUnder(p));
        return p.Z > below ? p.Z - below : double.MaxValue;
    }

    /// <summary>Mean gap across a path, mm, from a point by <paramref name="half"/> to both sides.</summary>
    /// <param name="p">The point.</param>
    /// <param name="half">Across the path, as long as half the width.</param>
    /// <param name="most">No gap is larger, mm.</param>
    /// <param name="limit">What is higher is beside the path, mm.</param>
    /// <param name="before">Later extrusions do not count.</param>
    /// <param name="least">A mean clearly below it may come out too small, mm.</param>
    /// <param name="known">An extrusion that counts, as the one below the point: others are looked for only where it leaves room. Null = none.</param>
    public double GapAcross(Vec3 p, Vec3 half, double most, double limit, int before, double least = 0, Extrusion? known = null)
    {
        const double Clearly = 0.999;
        // Nothing that is lower counts.
        double sum = 0, rest = 0, floor = FloorUnder(p), lowest = p.Z - most - 1e-6;
        for (var k = 0; k < Places; k++)
        {
            _known[k] = known?.TopAt(Place(k), 0) is { } top && top <= limit && top > lowest ? top : lowest;
            rest += Gap(_known[k]);
        }
        for (var k = 0; k < Places && sum + rest >= Clearly * least * Places; k++)
        {
            rest -= Gap(_known[k]);
            sum += Gap(Deposit.TopUnder(Place(k), limit, 0, before, null, _known[k]));
        }
        return sum / Places;

        Vec3 Place(int k) => p + half * ((2 * k + 1.0) / Places - 1);
        double Gap(double top) => Math.Min(most, Math.Max(0, p.Z - Math.Max(top, floor)));
    }

    /// <summary>The motion goes on from here.</summary>
    /// <param name="ahead">mm beyond the end of the last move.</param>
    /// <returns>Number of pieces that are no longer fresh.</returns>
    public int Advance(double ahead)
    {
        var first = _oldest;
        var fresh = _distance + ahead - Lag + 1e-9;
        while (_oldest < _newest && _fresh[_oldest].Distance <= fresh)
        {
            var begin = _oldest;
            ref var extrusion = ref _fresh[_oldest++];
            var to = extrusion.To;
            // Pieces of a line are one extrusion, also where they stop to be fresh one after the other.
            while (_oldest < _newest && _fresh[_oldest].GoesOn && _fresh[_oldest].Distance <= fresh) to = _fresh[_oldest++].To;
            var joined = IsJoined(begin, _oldest - 1);
            if (extrusion.GoesOn) Deposit.GoOn(extrusion.From, to, extrusion.Half, extrusion.Move, joined);
            else Deposit.Add(extrusion.From, to, extrusion.Half, extrusion.Move, joined);
            Strands?.Add(extrusion.From, to, extrusion.Half, extrusion.Tool, extrusion.Move);
        }
        return _oldest - first;
    }

    /// <summary>Highest point of the pieces that are no longer fresh since the last call of <see cref="Advance"/>, mm.</summary>
    /// <param name="count">What it returned.</param>
    public double TopOfLast(int count)
    {
        var top = double.NegativeInfinity;
        for (var i = _oldest - count; i < _oldest; i++) top = Math.Max(top, Math.Max(_fresh[i].From.Z, _fresh[i].To.Z));
        return top;
    }

    /// <summary>What the head does to these pieces where its tip goes straight from a to b, as <see cref="DepositContacts.Meets"/> says it of all.</summary>
    public HeadContact MeetsLast(int count, Vec3 a, Vec3 b, double tolerance, bool hitsOnly, out int move)
    {
        move = -1;
        if (!(TopOfLast(count) > Math.Min(a.Z, b.Z) + tolerance)) return HeadContact.None;
        var query = new HeadQuery(a, b, tolerance, Head, hitsOnly);
        for (var i = _oldest - count; i < _oldest; i++)
        {
            ref var piece = ref _fresh[i];
            if (!query.Meets(Extrusion.Of(piece.From, piece.To, piece.Half, -1, IsJoined(i, i)))) continue;
            move = piece.Move;
            return HeadContact.Hits;
        }
        return query.Digs ? HeadContact.Digs : HeadContact.None;
    }

    /// <summary>A straight move has been made.</summary>
    /// <param name="move">The move.</param>
    /// <param name="height">Height of its extrusion, mm; 0 if unknown.</param>
    public void Add(in CheckedMove move, double height)
    {
        _distance += move.Length;
        if (move.Kind != MoveKind.Print || !(move.Deposited > 0)) return;
        var bead = new Bead(move.Deposited / move.Length, height);
        // A bead of almost no height would be as wide as the bed.
        var half = Math.Min(bead.Width(_shape), _widest) / 2;
        Highest = Math.Max(Highest, Math.Max(move.Start.Z, move.End.Z));
        var tool = _kinematics is null ? Vec3.UnitZ : _kinematics.Direction(Vec3.Lerp(move.StartTurns, move.EndTurns, 0.5));
        // Its end in pieces, each of which stops to be fresh by itself.
        var at = move.Start;
        for (var piece = FreshPieces; piece > 0; piece--)
        {
            var rest = piece * FreshPiece;
            if (rest >= move.Length) continue;
            var next = Vec3.Lerp(move.Start, move.End, 1 - rest / move.Length);
            Keep(new Fresh(at, next, half, tool, move.Index, _distance - rest, at != move.Start));
            at = next;
        }
        Keep(new Fresh(at, move.End, half, tool, move.Index, _distance, at != move.Start));
    }

    /// <summary>What stands still around the print: the object, the bed and its clips.</summary>
    private static StrandGrid Around(PrintSetup setup)
    {
        var strands = new StrandGrid();
        if (setup.PrintedOn is { } mesh) Add(mesh, ObjectTag);
        var bed = setup.Printer.BuildBounds;
        Vec3 a = bed.Min, b = bed.Max.WithZ(bed.Min.Z), c = new(b.X, a.Y, a.Z), d = new(a.X, b.Y, a.Z);
        strands.Add(a, c, b, BedTag);
        strands.Add(a, b, d, BedTag);
        for (var i = 0; i < setup.Printer.Clips.Count; i++) Add(TriMesh.Box(setup.Printer.Clips[i]), ClipTag - i);
        return strands;

        void Add(TriMesh of, int tag)
        {
            for (var i = 0; i < of.TriangleCount; i++)
            {
                var (p, q, r) = of.Triangle(i);
                strands.Add(of.RawVertices[p], of.RawVertices[q], of.RawVertices[r], tag);
            }
        }
    }

    // Whether pieces that follow each other end, at their lower end, on one that goes on downward.
    private bool IsJoined(int first, int last)
    {
        var (from, to) = (_fresh[first].From, _fresh[last].To);
        if (to.Z > from.Z) return first > 0 && _fresh[first - 1].To == from && _fresh[first - 1].From.Z < from.Z;
        return last + 1 < _newest && _fresh[last + 1].From == to && _fresh[last + 1].To.Z < to.Z;
    }

    private void Keep(in Fresh piece)
    {
        if (_newest == _fresh.Length)
        {
            // The last one before them tells whether they go on from it.
            var first = Math.Max(0, _oldest - 1);
            var count = _newest - first;
            var fresh = count > _fresh.Length / 2 ? new Fresh[_fresh.Length * 2] : _fresh;
            Array.Copy(_fresh, first, fresh, 0, count);
            (_fresh, _oldest, _newest) = (fresh, _oldest - first, count);
        }
        _fresh[_newest++] = piece;
    }

    /// <summary>Radius and height of the nozzle, from the tip outward, mm.</summary>
    public static (double Radius, double Height)[] Outline(Printer printer) => [.. printer.HeadOutline.Select(p => (p.Radius, p.Height))];

    // A piece of an extrusion, and the length of motion at its end.
    private readonly record struct Fresh(Vec3 From, Vec3 To, double Half, Vec3 Tool, int Move, double Distance, bool GoesOn);
}
