namespace Caterpillar.Machines;

/// <summary>Toolpaths of printers with rotary axes: on the part, and as their files have them. Toolpaths of other printers stay as they are.</summary>
internal static class RotaryMoves
{
    /// <summary>The toolpath on the part with the words that the printer needs even where its tool is upright.</summary>
    public static Toolpath Turned(this Printer printer, Toolpath toolpath, CancellationToken cancel = default)
        => printer.Kinematics is { IsPolar: true } kinematics && !toolpath.HasTurns
            ? new ToolDirections(kinematics, _ => Vec3.UnitZ).Apply(toolpath, null, cancel) : toolpath;

    /// <summary>The toolpath as the file has it, of one on the part.</summary>
    public static Toolpath ToMachine(this Printer printer, Toolpath toolpath, CancellationToken cancel = default)
        => printer.Turned(toolpath, cancel) is { HasTurns: true } turned && MovesSlides(printer) is { } kinematics
            ? MachinePositions.ToMachine(turned, kinematics, new Vec3(printer.MaxSpeed.X, printer.MaxSpeed.Y, printer.MaxSpeed.Z), cancel) : toolpath;

    /// <summary>The toolpath on the part, of one as a file has it.</summary>
    public static Toolpath ToPart(this Printer printer, Toolpath toolpath, CancellationToken cancel = default)
        => toolpath.HasTurns && MovesSlides(printer) is { } kinematics ? MachinePositions.ToPart(toolpath, kinematics, cancel) : toolpath;

    private static Kinematics? MovesSlides(Printer printer) => printer.RotaryPositions != RotaryPositions.Tip ? printer.Kinematics : null;
}
