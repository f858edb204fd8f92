namespace Caterpillar.Checks;

/// <summary>Too much material extruded or retracted, in place or along a path, and extrusions that lack what was retracted before.</summary>
internal sealed class ExtruderCheck(PrintSetup setup, Findings findings) : MoveCheck
{
    // Cross-section in squares of the nozzle, and mm³ in cubes of it: purge lines are thick, and short moves may carry a drop.
    private const double ThickestArea = 36;
    private const double LargestDrop = 64;

    // Retraction along a path, in mm of filament and in retractions of the printer.
    private const double LongestWipe = 10;
    private const double MostRetractions = 2;

    // mm³ in cubes of the nozzle: what is retracted in the middle of an extrusion, and what only makes up for a retraction.
    private const double LeastTurn = 0.1;
    private const double LeastStarved = 20;

    private readonly double _nozzle = setup.Printer.NozzleDiameter;

    // All in mm³. What was pushed in place since the last move; what was retracted along paths and in place since the last extrusion.
    private double _inPlace, _wiped, _retracted;

    // What may be retracted along a path, also because as much was retracted in place before, as for a change of filament.
    private readonly double _usual
        = Math.Max(LongestWipe, MostRetractions * setup.RetractionLength) * ExtrusionModel.FilamentAreaOf(setup.Material.FilamentDiameter);

    private double _most;

    // The first move that retracts right after an extrusion, and the amount.
    private bool _printed;
    private int _turn = -1;
    private double _turned;

    // The first extrusion that makes up for a retraction, and the amount.
    private int _hungry;
    private double _starved;

    public override IReadOnlyList<string> Codes => [CheckCodes.Stationary, CheckCodes.Amount, CheckCodes.Starved];

    public override void Event(MoveEvent what)
    {
        if (what.Event is HomeEvent) _inPlace = 0;
        if (what.Event is not RetractionEvent set) return;
        var volume = Math.Max(set.Length ?? 0, set.Extra ?? 0) * ExtrusionModel.FilamentAreaOf(setup.Material.FilamentDiameter);
        if (volume > setup.Printer.MaxStationaryVolume) ReportInPlace(what.Move, set.Length > 0 ? -volume : volume);
    }

    public override void Move(in CheckedMove move)
    {
        if (move.StartKnown ? move.Start != move.End || move.Arc is not null : move.Kind is not (MoveKind.Retract or MoveKind.Deretract or MoveKind.Prime))
        {
            _inPlace = 0;
            if (move.Pushed < 0) Retract(move);
            else if (move.Pushed > 0) Extrude(move);
            else (_printed, _turn) = (false, -1);
            return;
        }
        (_printed, _turn) = (false, -1);
        if (move.Pushed is < 0 or > 0) _retracted = Math.Max(0, _retracted - move.Pushed);
        if (_retracted > _most) _most = _retracted;
        var before = Math.Abs(_inPlace);
        _inPlace += move.Pushed;
        var most = setup.Printer.MaxStationaryVolume * (1 + 1e-9);
        var volume = Math.Abs(move.Pushed) > Math.Abs(_inPlace) ? move.Pushed : _inPlace;
        if (!(Math.Abs(volume) > most) || (before > most && Math.Abs(move.Pushed) <= most)) return;
        ReportInPlace(move.Index, volume);
    }

    private void Retract(in CheckedMove move)
    {
        var (before, most) = (_wiped, Math.Max(_usual, _most));
        _wiped -= move.Pushed;
        if (_wiped > most && (before <= most || -move.Pushed > most)) ReportWipe(move.Index, _wiped);
        if (_printed) (_turn, _turned) = (move.Index, 0);
        _printed = false;
        _turned -= move.Pushed;
    }

    private void Extrude(in CheckedMove move)
    {
        var cube = _nozzle * _nozzle * _nozzle;
        var turns = _turn >= 0 && _turned > LeastTurn * cube;
        if (turns) ReportTurn(_turn, _turned);
        _turn = -1;
        if (move.Pushed > move.Deposited)
        {
            if (_starved == 0) _hungry = move.Index;
            _starved += move.Pushed - move.Deposited;
        }
        if (!(move.Deposited > 0)) return;
        // Filament that was changed is loaded along a path, too.
        if (_starved > LeastStarved * cube && !turns && _wiped + _retracted <= _usual) ReportStarved(_hungry, _starved);
        _printed = true;
        _wiped = _retracted = _starved = 0;
        if (move.Deposited > _nozzle * _nozzle * (ThickestArea * move.Length + LargestDrop * _nozzle)) ReportThick(move);
    }

    private void ReportInPlace(int move, double volume)
        => findings.Add(CheckCodes.Stationary, move,
            () => $"{Figures.Short(Math.Abs(volume))} mm³ are {(volume > 0 ? "extruded" : "retracted")} in place, but {setup.Printer.Title} allows only "
                + $"{Figures.Short(setup.Printer.MaxStationaryVolume)} mm³. Move the head, or {(volume > 0 ? "extrude" : "retract")} less.", Math.Abs(volume));

    private void ReportWipe(int move, double volume)
        => findings.Add(CheckCodes.Amount, move,
            () => $"{Figures.Short(volume)} mm³ are retracted while the head moves, more than any retraction before. "
                + "Correct the E value, or the mode of E before it (M82, M83, G92).", volume);

    private void ReportThick(in CheckedMove move)
    {
        var (volume, length) = (move.Deposited, move.Length);
        findings.Add(CheckCodes.Amount, move.Index,
            () => $"{Figures.Short(volume)} mm³ are extruded along {Figures.Short(length)} mm, far more than a nozzle of "
                + $"{Figures.Short(_nozzle)} mm prints. Correct the E value, or the mode of E before it (M82, M83, G92).", volume);
    }

    private void ReportTurn(int move, double volume)
        => findings.Add(CheckCodes.Starved, move,
            () => $"{Figures.Short(volume)} mm³ are retracted in the middle of an extrusion, which leaves a gap. Check the sign of E.", volume);

    private void ReportStarved(int move, double volume)
        => findings.Add(CheckCodes.Starved, move,
            () => $"{Figures.Short(volume)} mm³ of extrusions only make up for what was retracted before, and print nothing. "
                + "Deretract first, or check E.", volume);
}
