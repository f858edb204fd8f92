namespace Caterpillar.Checks;

/// <summary>E that makes sense only in the other mode, absolute or relative, in a layer or in a part of it.</summary>
internal sealed class ModeCheck(Printer printer, Findings findings) : MoveCheck
{
    // Moves with E before a layer is judged, and the most that are judged together.
    private const int Enough = 20;
    private const int Most = 500;

    // The part of them that must look wrong.
    private const double MostWipes = 0.25;
    private const double MostIdle = 0.25;
    private const double MostLost = 0.5;
    private const double MostThick = 0.5;

    // Area of an extrusion in squares of the nozzle that no nozzle prints.
    private const double ThickArea = 16;
    private int _layer, _moving, _wipes, _idle, _prints, _thick;
    private int _firstWipe, _firstIdle, _firstThick;

    public override IReadOnlyList<string> Codes => [CheckCodes.ExtrusionMode];

    public override void Move(in CheckedMove move)
    {
        if (move.E == 0 || !(move.Length > 0)) return;
        if ((move.Layer != _layer && _moving >= Enough) || _moving == Most) Judge();
        _layer = move.Layer;
        _moving++;
        if (move.E < 0)
        {
            if (_wipes++ == 0) _firstWipe = move.Index;
        }
        else if (move.Deposited > 0)
        {
            _prints++;
            if (move.Deposited > ThickArea * printer.NozzleDiameter * printer.NozzleDiameter * move.Length && _thick++ == 0) _firstThick = move.Index;
        }
        else if (move.Deposited == 0)
        {
            if (_idle++ == 0) _firstIdle = move.Index;
        }
    }

    public override void End(Toolpath whole) => Judge();

    private void Judge()
    {
        // Wipes alone are no fault: what follows a wipe prints. In the wrong mode most only makes up for what was retracted.
        if (_moving >= Enough && _wipes > _moving * MostWipes && _idle > _moving * MostIdle) ReportWipes(_firstWipe, Percent(_wipes, _moving));
        else if (_moving >= Enough && _idle > _moving * MostLost) ReportIdle(_firstIdle, Percent(_idle, _moving));
        else if (_prints >= Enough && _thick > _prints * MostThick) ReportThick(_firstThick, Percent(_thick, _prints));
        _moving = _wipes = _idle = _prints = _thick = 0;
    }

    private void ReportWipes(int move, string share)
        => findings.Add(CheckCodes.ExtrusionMode, move, () => $"{share} of the moves with E retract. E looks relative, but is read as absolute. "
            + "Add M83 before the first such move.");

    private void ReportIdle(int move, string share)
        => findings.Add(CheckCodes.ExtrusionMode, move, () => $"{share} of the moves with E print nothing: they make up for what was retracted before. "
            + "Add G92 E0 where E begins again, or M83 if E is relative.");

    private void ReportThick(int move, string share)
        => findings.Add(CheckCodes.ExtrusionMode, move, () => $"{share} of the extrusions are thicker than any nozzle prints. E looks absolute, but is read "
            + "as relative, or in another unit. Add M82 before the first such move, or correct e_unit of the printer.");

    private static string Percent(int part, int whole) => NumberFormatter.Format(100.0 * part / whole, 0) + " %";
}
