namespace Caterpillar.Simulation;

/// <summary>
/// Machine limits in the comments of files from PrusaSlicer and its descendants (machine_max_…). Their time estimates use classic jerk, plan 64 moves ahead,
/// and leave out waits for heating.
/// </summary>
public static class SlicerLimits
{
    /// <summary>The printer with the limits of a file; null if the file has none.</summary>
    /// <param name="settings">Settings from the comments of a file, by name.</param>
    /// <param name="like">The printer to change.</param>
    /// <param name="silent">Use the second value of each limit, for the silent mode.</param>
    public static Printer? Of(IReadOnlyDictionary<string, string> settings, Printer like, bool silent = false)
    {
        if (settings is null) throw new ArgumentNullException(nameof(settings));
        if (like is null) throw new ArgumentNullException(nameof(like));
        if (Axes(settings, "machine_max_feedrate", silent) is not { } speed) return null;
        if (Axes(settings, "machine_max_acceleration", silent) is not { } acceleration) return null;
        if (Axes(settings, "machine_max_jerk", silent) is not { } jerk) return null;
        if (Value(settings, "machine_max_acceleration_extruding", silent) is not { } print) return null;
        // Older Marlin has no acceleration of its own for travels.
        var old = settings.TryGetValue("gcode_flavor", out var flavor) && flavor == "marlin";
        var travel = old ? null : Value(settings, "machine_max_acceleration_travel", silent);
        return like with
        {
            Cornering = Cornering.Jerk,
            MaxSpeed = speed,
            MaxAcceleration = acceleration,
            Jerk = jerk,
            PrintAcceleration = print,
            TravelAcceleration = travel is > 0 ? travel.Value : print,
            RetractionAcceleration = Value(settings, "machine_max_acceleration_retracting", silent) ?? print,
            LookaheadMoves = 64,
            NozzleHeating = 0,
            BedHeating = 0,
        };
    }

    private static AxisValues? Axes(IReadOnlyDictionary<string, string> settings, string name, bool silent)
        => Value(settings, name + "_x", silent) is { } x && Value(settings, name + "_y", silent) is { } y
            && Value(settings, name + "_z", silent) is { } z && Value(settings, name + "_e", silent) is { } e ? new AxisValues(x, y, z, e) : null;

    private static double? Value(IReadOnlyDictionary<string, string> settings, string name, bool silent)
    {
        if (!settings.TryGetValue(name, out var text)) return null;
        var parts = text.Split(',');
        return NumberReader.TryParse(parts[silent && parts.Length > 1 ? 1 : 0].Trim(), out var value) && value is >= 0.01 and <= 100_000 ? value : null;
    }
}
