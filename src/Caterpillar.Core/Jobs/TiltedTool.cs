namespace Caterpillar.Jobs;

/// <summary>Leans the tool of a printer with rotary axes.</summary>
public static class TiltedTool
{
    /// <summary>
    /// The toolpath with rotary words (<see cref="ToolDirections"/>). Extrusions at which the head would hit what was printed before, the object, the bed or
    /// clips lean less, down to upright.
    /// </summary>
    /// <param name="toolpath">A plan for an upright tool.</param>
    /// <param name="setup">The printer, and the object that it prints on.</param>
    /// <param name="aim">Where the tool points.</param>
    /// <param name="progress">0 to 1.</param>
    /// <param name="cancel">Cancels.</param>
    /// <exception cref="ArgumentException">The printer has no rotary axes, or the aim has no direction.</exception>
    public static Toolpath Apply(
        Toolpath toolpath, PrintSetup setup, ToolAim aim, IProgress<double>? progress = null, CancellationToken cancel = default)
    {
        if (toolpath is null) throw new ArgumentNullException(nameof(toolpath));
        if (setup is null) throw new ArgumentNullException(nameof(setup));
        if (aim is null) throw new ArgumentNullException(nameof(aim));
        var kinematics = setup.Printer.Kinematics ?? throw new ArgumentException("The printer has no rotary axes.", nameof(setup));
        var direction = aim.Direction ?? throw new ArgumentException("Without a field the aim must have a direction.", nameof(aim));
        var guard = new LeanGuard(setup, kinematics, toolpath);
        return new ToolDirections(kinematics, direction) { MaxTilt = aim.MaxTilt, Refuses = guard.Refuses, Printed = guard.Add }
            .Apply(toolpath, progress, cancel);
    }
}
