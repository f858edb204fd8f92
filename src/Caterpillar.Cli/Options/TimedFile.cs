namespace Caterpillar.Cli;

/// <summary>The times of a file, with the limits of the given printer, else of the setup or the slicer in the file, else of the generic printer.</summary>
internal sealed record TimedFile(Timeline Timeline, string Limits)
{
    public static TimedFile Of(SetupOptions options, ParseResult arguments, DecodedGCode decoded, string name, Session session)
    {
        var (setup, limits) = LimitsOf(options.Resolve(arguments, session), options.IsGiven(arguments), decoded);
        setup = setup with { Printer = decoded.AxesOn(setup.Printer) };
        var toolpath = decoded.Unrolled(setup.Printer);
        return new TimedFile(session.WithProgress("Planning " + name, progress => Timeline.Of(toolpath, setup, progress, session.Cancel)), limits);
    }

    private static (PrintSetup Setup, string Limits) LimitsOf(PrintSetup setup, bool isGiven, DecodedGCode decoded)
    {
        if (isGiven) return (setup, "printer " + setup.Printer.Name);
        if (FileSetup.Of(decoded.Settings) is { } written) return (written, "the setup in the file");
        var own = setup.Printer with { Flavor = decoded.Flavor };
        return SlicerLimits.Of(decoded.Settings, own) is { } printer
            ? (setup with { Printer = printer }, "the slicer's settings in the file")
            : (setup with { Printer = own }, "printer " + setup.Printer.Name);
    }
}
