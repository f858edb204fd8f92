namespace Caterpillar.Machines;

/// <summary>The pause of a printer.</summary>
internal static class PauseMoves
{
    /// <summary>A pause according to the printer's keys <c>pause_lift_mm</c> and so on.</summary>
    public static Pause Of(PrintSetup setup)
    {
        var printer = setup.Printer;
        return new Pause
        {
            Lift = printer.PauseLift,
            MaxHeight = printer.BuildVolume.Z,
            Park = printer.PausePark.Count > 0 ? printer.PausePark[0] : null,
            Retraction = printer.PauseRetraction,
            Prime = printer.PausePrime,
            FilamentArea = ExtrusionModel.FilamentAreaOf(setup.Material.FilamentDiameter),
            TravelSpeed = setup.Settings.TravelSpeed,
            ZHopSpeed = printer.ZHopSpeed,
            RetractionSpeed = printer.RetractionSpeed,
            Command = string.Join("\n", printer.PauseGCode),
        };
    }
}
