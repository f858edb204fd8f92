namespace Caterpillar.Jobs;

/// <summary>The part of the bed that the start G-code prints on, as with a prime line.</summary>
public static class PrimedArea
{
    /// <summary>The printer of a setup with the areas of its bed that models leave free: the primed one, and with a purge tower a place for that.</summary>
    /// <param name="setup">The setup.</param>
    /// <param name="isForTower">True for the tower itself.</param>
    public static Printer Excluded(PrintSetup setup, bool isForTower = false)
    {
        var area = Of(setup);
        var printer = area.IsEmpty ? setup.Printer : setup.Printer with { ExcludedAreas = new(setup.Printer.ExcludedAreas.Append(area)) };
        return isForTower ? printer : TowerPlace.Reserve(printer, setup.Settings);
    }

    /// <summary>Box around the extrusions of the start G-code, mm; empty if there are none or if the start G-code depends on the print.</summary>
    public static Bounds Of(PrintSetup setup)
    {
        if (setup is null) throw new ArgumentNullException(nameof(setup));
        if (SetupFormat.OfUnknown(setup) is not { Start.Count: > 0 } format) return Bounds.Empty;
        var text = Encoding.UTF8.GetBytes(string.Join("\n", format.Start));
        var options = new DecodeOptions { Flavor = setup.Printer.Flavor, FilamentDiameter = setup.Material.FilamentDiameter };
        if (GCodeDecoder.Decode(text, options).Value is not { } start) return Bounds.Empty;
        var box = Bounds.Empty;
        foreach (var move in start.Toolpath.Moves())
        {
            if (move.Kind == MoveKind.Print && move.Deposited > 0) box = box.Include(move.Start).Include(move.End);
        }
        var half = new Vec3(1, 1) * (setup.Printer.NozzleDiameter / 2);
        return box.IsEmpty ? box : new Bounds(box.Min - half, box.Max + half);
    }
}
