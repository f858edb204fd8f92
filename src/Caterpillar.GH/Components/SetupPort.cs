namespace Caterpillar.GH.Components;

/// <summary>The setup of a component: the connected one, else the one that its paths or its toolpath were made with, else the generic one.</summary>
internal static class SetupPort
{
    private const int MostKeys = 8;

    // Longer values, such as G-code, are not shown.
    private const int MostLetters = 12;

    /// <summary>The setup of something new.</summary>
    public static PrintSetup Of(Run run, int input) => run.Maybe<PrintSetup>(input) ?? Generic(run);

    /// <summary>The setup for print paths or steps that were made with some. A warning names what differs.</summary>
    public static PrintSetup Of(Run run, int input, IEnumerable<PrintSetup?> made)
    {
        var known = made.Where(s => s is not null).Select(s => s!).Distinct().ToArray();
        var setup = run.Maybe<PrintSetup>(input) ?? known.FirstOrDefault() ?? Generic(run);
        foreach (var other in known) Compare(run, setup, other, "Print paths were made with another setup");
        return setup;
    }

    /// <summary>The setup for a toolpath. A decoded file without one has the limits in its comments.</summary>
    public static PrintSetup Of(Run run, int input, ToolpathGoo goo)
    {
        var connected = input < 0 ? null : run.Maybe<PrintSetup>(input);
        if (connected is not null && goo.Setup is not null) Compare(run, connected, goo.Setup, "The toolpath was made with another setup");
        return connected ?? goo.Setup ?? OfFile(run, goo);
    }

    /// <summary>The bead of a port, else that of the setup; and the setup to remember, which is none if the bead is given without one.</summary>
    public static (Bead Bead, PrintSetup? Setup) Bead(Run run, int bead, int setup)
    {
        var given = run.Maybe<BeadGoo>(bead) is { IsValid: true } goo ? goo.Value : (Bead?)null;
        var connected = run.Maybe<PrintSetup>(setup);
        if (given is { } own) return (own, connected);
        connected ??= Generic(run);
        var settings = connected.Settings;
        return (Toolpaths.Bead.FromWidth(settings.LineWidth, settings.LayerHeight, shape: settings.BeadShape), connected);
    }

    // The profiles of the plug-in, unless the user has changed the generic printer.
    private static PrintSetup Generic(Run run)
    {
        var own = File.GetLastWriteTimeUtc(System.IO.Path.Combine(Profiles.UserFolder, "generic.json"));
        return run.Require(run.Cached(["generic", own], () => Profiles.Setup()));
    }

    private static PrintSetup OfFile(Run run, ToolpathGoo goo)
    {
        if (goo.DecodedGCode is not { } file) return Generic(run);
        var own = new Printer { Flavor = file.Flavor };
        return run.Cached([file], () => new PrintSetup() with { Printer = SlicerLimits.Of(file.Settings, own) ?? own });
    }

    private static void Compare(Run run, PrintSetup setup, PrintSetup other, string what)
    {
        if (setup.Equals(other)) return;
        var keys = setup.Differences(other).Select(d => Math.Max(d.Value.Length, d.Other.Length) > MostLetters ? d.Key
            : $"{d.Key} ({d.Other}, here {d.Value})").ToList();
        if (!ReferenceEquals(setup.PrintedOn, other.PrintedOn)) keys.Add("what is printed on");
        if (keys.Count == 0) return;
        var more = keys.Count > MostKeys ? $" and {NumberFormatter.Format(keys.Count - MostKeys)} more" : "";
        run.Report([new Diagnostic(Severity.Warning, "setup.differs",
            $"{what}: {string.Join(", ", keys.Take(MostKeys))}{more} differ. Connect the same Print Setup to both.")]);
    }
}
