namespace Caterpillar.Checks;

/// <summary>Passes each move to the checks of extrusions and collisions as straight pieces, and records its extrusion.</summary>
internal sealed class DepositCheck : MoveCheck
{
    private const double ArcTolerance = 0.02;
    private readonly double _farthest;
    private readonly CancellationToken _cancel;
    private readonly PrintedSoFar _printed;
    private readonly ExtrusionCheck _extrusions;
    private readonly CollisionCheck? _collisions;

    // Deltas, which have round beds, home upward.
    private readonly bool _homesUp;

    // What is printed is not remembered, and what is well above the bed not looked at.
    private readonly bool _isOnlyBed;
    private readonly double _nearBed;

    public DepositCheck(PrintSetup setup, Findings findings, CancellationToken cancel = default, bool isOnlyBed = false)
    {
        (_cancel, _isOnlyBed) = (cancel, isOnlyBed);
        _nearBed = (setup.PrintedOn?.Bounds.Max.Z ?? 0) + setup.Settings.LargerLayerHeight;
        _homesUp = setup.Printer.BedShape == BedShape.Round;
        var volume = setup.Printer.BuildVolume;
        _farthest = System.Math.Max(10_000, 2 * (volume.X + volume.Y + volume.Z));
        _printed = new PrintedSoFar(setup);
        _extrusions = new ExtrusionCheck(setup, _printed, findings);
        if (!isOnlyBed && findings.LooksFor(CollisionCheck.Codes)) _collisions = new CollisionCheck(setup.Printer, _printed, findings);
    }

    public override IReadOnlyList<string> Codes => AllCodes;

    public static IReadOnlyList<string> AllCodes { get; } = [.. ExtrusionCheck.Codes, .. CollisionCheck.Codes];

    public override void Move(in CheckedMove move)
    {
        if (move.Arc is not { } arc || IsFar(move.Start) || IsFar(move.End))
        {
            Piece(move);
            return;
        }
        var chords = arc.ChordCount(move.Start, move.End, ArcTolerance);
        var piece = move;
        piece.Arc = null;
        piece.Length = move.Length / chords;
        piece.Deposited = move.Deposited / chords;
        for (var k = 1; k <= chords; k++)
        {
            if ((k & 0xFF) == 1) _cancel.ThrowIfCancellationRequested();
            piece.End = arc.PointAt(move.Start, move.End, (double)k / chords);
            piece.EndTurns = Vec3.Lerp(move.StartTurns, move.EndTurns, (double)k / chords);
            Piece(piece);
            (piece.Start, piece.StartTurns) = (piece.End, piece.EndTurns);
        }
    }

    public override void End(Toolpath toolpath) => _extrusions.End();

    // What is far outside the machine touches nothing; numbers of any size must not stop the checks.
    private bool IsFar(Vec3 p) => !(System.Math.Abs(p.X) < _farthest && System.Math.Abs(p.Y) < _farthest && System.Math.Abs(p.Z) < _farthest);

    // Homing goes along X, then Y, then down. Firmware raises the head only above a height of its configuration, if at all.
    private void Home(in CheckedMove move)
    {
        _printed.Advance(0);
        var piece = move;
        foreach (var end in new[] { new Vec3(move.End.X, move.Start.Y, move.Start.Z), move.End.WithZ(move.Start.Z), move.End })
        {
            piece.End = end;
            piece.Length = piece.Start.DistanceTo(end);
            if (piece.Length > 0) _collisions?.Check(piece, 0);
            piece.Start = end;
        }
    }

    private void Piece(in CheckedMove move)
    {
        if (!move.StartKnown || IsFar(move.Start) || IsFar(move.End))
        {
            _extrusions.Break();
            if (move.HomesFromKnown && !_homesUp && !IsFar(move.Start)) Home(move);
            return;
        }
        if (_isOnlyBed && _extrusions.HasBegun && System.Math.Min(move.Start.Z, move.End.Z) > _nearBed + move.Thickness) return;
        _printed.Advance(0);
        if (!(move.Length > 0))
        {
            if (move.Kind == MoveKind.Prime) _extrusions.Blob(move);
            if (move.StartTurns != move.EndTurns) _collisions?.Check(move, 0);
            return;
        }
        (double Nominal, double Filled) height = default;
        if (move.Kind == MoveKind.Print && move.Deposited > 0) height = _extrusions.Extrusion(move);
        else _extrusions.Break();
        _collisions?.Check(move, height.Nominal);
        if (!_isOnlyBed) _printed.Add(move, height.Filled);
    }
}
