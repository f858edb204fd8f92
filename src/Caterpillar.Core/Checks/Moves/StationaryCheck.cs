using Caterpillar.Machines;
using Caterpillar.Toolpaths;

namespace Caterpillar.Checks;

/// <summary>Too much material extruded or retracted in place, in one move or in several.</summary>
internal sealed class StationaryCheck(Printer printer, Findings findings) : IMoveCheck
{
    private double _pushed;

    public IReadOnlyList<string> Codes => [CheckCodes.Stationary];

    public void Event(MoveEvent what)
    {
        if (what.Event is HomeEvent) _pushed = 0;
    }

    public void Move(in CheckedMove move)
    {
        if (!move.StartKnown ? move.Kind is not (MoveKind.Retract or MoveKind.Deretract or MoveKind.Prime) : move.Start != move.End || move.Arc is not null)
        {
            _pushed = 0;
            return;
        }
        var before = Math.Abs(_pushed);
        _pushed += move.Pushed;
        var most = printer.MaxStationaryVolume * (1 + 1e-9);
        var volume = Math.Abs(move.Pushed) > Math.Abs(_pushed) ? move.Pushed : _pushed;
        if (!(Math.Abs(volume) > most) || (before > most && Math.Abs(move.Pushed) <= most)) return;
        Report(move.Index, volume);
    }

    public void End(Toolpath toolpath)
    {
    }

    private void Report(int move, double volume)
        => findings.Add(CheckCodes.Stationary, move,
            () => $"{Figures.Short(Math.Abs(volume))} mm³ are {(volume > 0 ? "extruded" : "retracted")} in place, but {printer.Title} allows only "
                + $"{Figures.Short(printer.MaxStationaryVolume)} mm³. Move the head, or {(volume > 0 ? "extrude" : "retract")} less.", Math.Abs(volume));
}
