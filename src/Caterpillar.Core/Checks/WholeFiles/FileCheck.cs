using Caterpillar.Machines;
using Caterpillar.Toolpaths;

namespace Caterpillar.Checks;

/// <summary>Rules for a whole file: home before printing, have a known position, and use the E mode that it states.</summary>
internal sealed class FileCheck(Toolpath toolpath, Printer printer, CheckScope scope, Findings findings) : IMoveCheck
{
    // Moves with E before a file is judged, and the part of them that must look wrong.
    private const int Enough = 20;
    private const double MostWipes = 0.25;
    private const double MostThick = 0.5;

    // Area of an extrusion in squares of the nozzle that no nozzle prints.
    private const double ThickArea = 16;
    private bool _homes;
    private bool _reported;
    private bool _hasX = toolpath.Start is not null, _hasY = toolpath.Start is not null, _hasZ = toolpath.Start is not null;
    private long _moving, _wipes, _prints, _thick;
    private int _firstWipe, _firstThick;

    public IReadOnlyList<string> Codes => [CheckCodes.ExtrusionMode, CheckCodes.NoHoming, CheckCodes.UnknownPosition];

    public void Event(MoveEvent what)
    {
        if (what.Event is not HomeEvent home) return;
        _homes = true;
        _hasX |= home.X;
        _hasY |= home.Y;
        _hasZ |= home.Z;
    }

    public void Move(in CheckedMove move)
    {
        _hasX |= move.End.X != move.Start.X;
        _hasY |= move.End.Y != move.Start.Y;
        _hasZ |= move.End.Z != move.Start.Z;
        if (!(move.Length > 0)) return;
        if (move.Kind == MoveKind.Print && move.E > 0) Printed(move);
        if (move.E == 0) return;
        _moving++;
        if (move.Kind == MoveKind.Wipe)
        {
            if (_wipes++ == 0) _firstWipe = move.Index;
        }
        else if (move.Deposited > 0)
        {
            _prints++;
            var area = move.Deposited / move.Length;
            if (area > ThickArea * printer.NozzleDiameter * printer.NozzleDiameter && _thick++ == 0) _firstThick = move.Index;
        }
    }

    public void End(Toolpath whole)
    {
        if (scope.IsPlanned) return;
        if (_moving >= Enough && _wipes > _moving * MostWipes)
            findings.Add(CheckCodes.ExtrusionMode, _firstWipe,
                () => $"{Percent(_wipes, _moving)} of the moves with E retract. E looks relative, but is read as absolute. "
                + "Add M83 before the first move.");
        else if (_prints >= Enough && _thick > _prints * MostThick)
            findings.Add(CheckCodes.ExtrusionMode, _firstThick, ()
                => $"{Percent(_thick, _prints)} of the extrusions are thicker than any nozzle prints. E looks "
                + "absolute, but is read as relative, or in another unit. Add M82 before the first move, or correct e_unit of the printer.");
    }

    private void Printed(in CheckedMove move)
    {
        if (_reported || !scope.IsWholeFile || scope.HasMacros) return;
        _reported = true;
        if (!_homes) findings.Add(CheckCodes.NoHoming, move.Index, () => "The file prints without homing first. Add G28 to the start G-code.");
        if (_hasX && _hasY && _hasZ) return;
        var axes = string.Join(", ", new[] { _hasX ? "" : "X", _hasY ? "" : "Y", _hasZ ? "" : "Z" }.Where(a => a.Length > 0));
        findings.Add(CheckCodes.UnknownPosition, move.Index, () => $"The file prints before the position in {axes} is known. Home first, or move in {axes}.");
    }

    private static string Percent(long part, long whole) => NumberFormatter.Format(100.0 * part / whole, 0) + " %";
}
