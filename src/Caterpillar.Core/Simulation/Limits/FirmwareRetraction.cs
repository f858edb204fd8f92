namespace Caterpillar.Simulation;

/// <summary>G10 and G11: lengths and speeds are those of the printer until the file sets others, and a second retraction does nothing.</summary>
internal sealed class FirmwareRetraction(Printer printer)
{
    private bool _retracted;
    private double _retractedBy;
    private double _length = printer.RetractionLength;
    private double _speed = printer.RetractionSpeed;
    private double _extra = printer.DeretractionExtra;
    private double _back = printer.DeretractionSpeed;

    /// <summary>Change of E in mm of filament, and its speed in mm/s.</summary>
    public (double E, double Speed) Move(MoveKind kind)
    {
        var retracts = kind == MoveKind.Retract;
        if (retracts == _retracted) return (0, 0);
        _retracted = retracts;
        if (!retracts) return (_retractedBy + _extra, _back > 0 ? _back : _speed);
        _retractedBy = _length;
        return (-_length, _speed);
    }

    /// <summary>Takes settings of the file. After them, G11 of Klipper does nothing until the next G10.</summary>
    public void Set(RetractionEvent what)
    {
        (_length, _speed) = (what.Length ?? _length, what.Speed ?? _speed);
        (_extra, _back) = (what.Extra ?? _extra, what.Back ?? _back);
        _retracted &= printer.Flavor.RetractionSettings != RetractionCommands.Klipper;
    }
}
