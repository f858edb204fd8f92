namespace Caterpillar.Cli;

/// <summary>The times of a file, with the limits of the given printer, else of the setup or the slicer in the file, else of the generic printer.</summary>
internal sealed record TimedFile(Toolpath Toolpath, PrintSetup Setup, string Limits)
{
    public static TimedFile Of(SetupOptions options, ParseResult arguments, DecodedGCode decoded, Session session)
    {
        var (setup, limits) = LimitsOf(options.Resolve(arguments, session), options.IsGiven(arguments), decoded);
        setup = setup with { Printer = decoded.AxesOn(setup.Printer) };
        return new TimedFile(decoded.Unrolled(setup.Printer), setup, limits);
    }

    public Timeline Timeline(string name, Session session)
        => session.WithProgress("Planning " + name, progress => Simulation.Timeline.Of(Toolpath, Setup, progress, session.Cancel));

    public PrintStatistics Statistics(string name, Session session)
        => session.WithProgress("Planning " + name, progress => PrintStatistics.Of(Toolpath, Setup, progress, session.Cancel));

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
