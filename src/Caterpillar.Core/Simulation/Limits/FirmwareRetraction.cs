namespace Caterpillar.Simulation;

/// <summary>G10 and G11: the distance and speed are those of the printer, and a second retraction does nothing.</summary>
internal sealed class FirmwareRetraction(Printer printer)
{
    private bool _retracted;

    /// <summary>Change of E in mm of filament, and its speed in mm/s.</summary>
    public (double E, double Speed) Move(MoveKind kind)
    {
        var retracts = kind == MoveKind.Retract;
        if (retracts == _retracted) return (0, 0);
        _retracted = retracts;
        if (retracts) return (-printer.RetractionLength, printer.RetractionSpeed);
        return (printer.RetractionLength + printer.DeretractionExtra, printer.DeretractionSpeed > 0 ? printer.DeretractionSpeed : printer.RetractionSpeed);
    }
}
