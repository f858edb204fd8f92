namespace Caterpillar.Jobs;

/// <summary>Leans the tool of a printer with rotary axes.</summary>
public static class TiltedTool
{
    // Leans to the sides of a thin wall that are tried in turn, degrees: fronts of it that meet leave no room for a tool between them.
    private static readonly double[] Asides = [0, -40, 40];

    /// <summary>An aim along the normals of layers.</summary>
    /// <param name="field">The layers.</param>
    /// <param name="maxTilt">Maximum lean from vertical, degrees.</param>
    public static ToolAim Along(LayerField field, double maxTilt = 90)
        => field is null ? throw new ArgumentNullException(nameof(field)) : new ToolAim(field.Normal, maxTilt) { Side = field.Side };

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
        var speeds = new Vec3(setup.Printer.MaxSpeed.X, setup.Printer.MaxSpeed.Y, setup.Printer.MaxSpeed.Z);
        var (best, fewest) = (toolpath, int.MaxValue);
        double[] asides = aim.Side is null ? [0] : Asides;
        for (var i = 0; i < asides.Length && fewest > 0; i++)
        {
            var aside = asides[i];
            var guard = new LeanGuard(setup, kinematics, toolpath);
            var directions = new ToolDirections(kinematics, aside == 0 ? direction : p => Turned(direction(p), aim.Side!(p), aside))
            {
                MaxTilt = aim.MaxTilt, SlideSpeeds = setup.Printer.RotaryPositions == RotaryPositions.Tip ? speeds : null,
                Refuses = guard.Refuses, RefusedIn = guard.RefusedIn, Printed = guard.Add,
            };
            var leaning = directions.Apply(toolpath, progress.Part((double)i / asides.Length, (i + 1.0) / asides.Length), cancel, out var refused);
            if (refused < fewest) (best, fewest) = (leaning, refused);
        }
        progress?.Report(1);
        return best;
    }

    private static Vec3 Turned(Vec3 direction, Vec3 side, double degrees) => direction.Unit() * Angle.Cos(degrees) + side.Unit() * Angle.Sin(degrees);
}
