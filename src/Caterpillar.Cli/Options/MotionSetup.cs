using Caterpillar.GCode;
using Caterpillar.Simulation;

namespace Caterpillar.Cli;

/// <summary>
/// Motion limits for the time of a file: from the given printer, else from the slicer's settings in the file, else from the generic printer.
/// </summary>
internal sealed record MotionSetup(PrintSetup Setup, string Limits)
{
    public static MotionSetup Of(SetupOptions options, ParseResult arguments, DecodedGCode decoded, Session session)
    {
        var setup = options.Resolve(arguments, session);
        if (options.IsGiven(arguments)) return new MotionSetup(setup, "printer " + setup.Printer.Name);
        var own = setup.Printer with { Flavor = decoded.Flavor };
        return SlicerLimits.Of(decoded.Settings, own) is { } printer
            ? new MotionSetup(setup with { Printer = printer }, "the slicer's settings in the file")
            : new MotionSetup(setup with { Printer = own }, "printer " + setup.Printer.Name);
    }
}
