using Caterpillar.GH.Base;
using Caterpillar.GH.Goos;
using Caterpillar.GH.Params;
using Caterpillar.GH.Plugin;
using Caterpillar.Machines;
using Caterpillar.Simulation;

namespace Caterpillar.GH.Components;

/// <summary>The printer, material and settings of a toolpath: from ports, else from its plan, else from the file it was decoded from.</summary>
internal static class SetupPorts
{
    public static void Printer(InputPorts ports) => ports.Printer("P", "Default: as used for planning, the limits in the file, or generic.");

    public static void Material(InputPorts ports) => ports.Material("M", "Default: as used for planning, or as in the printer profile.");

    public static void Settings(InputPorts ports) => ports.Settings("S", "Default: as used for planning, or as in the printer profile.");

    /// <summary>The setup for a printer, by default the printer of the toolpath.</summary>
    public static PrintSetup Of(Run run, ToolpathGoo goo, Printer? printer, Material? material = null, PrintSettings? settings = null)
    {
        var planned = goo.Setup;
        var target = printer ?? planned?.Printer ?? OfFile(goo) ?? new Printer();
        return new PrintSetup(target,
            material ?? planned?.Material ?? run.Accept(Profiles.Library.Material(target.DefaultMaterial)) ?? new Material(),
            settings ?? planned?.Settings ?? run.Accept(Profiles.Library.Settings(target.DefaultSettings)) ?? new PrintSettings())
        { PrintedOn = planned?.PrintedOn };
    }

    /// <summary>A printer with a material and settings, by default those that it names. Without such a profile the item has no result.</summary>
    public static PrintSetup For(Run run, Printer printer, Material? material, PrintSettings? settings)
    {
        material ??= run.Accept(Profiles.Library.Material(printer.DefaultMaterial));
        settings ??= run.Accept(Profiles.Library.Settings(printer.DefaultSettings));
        return material is null || settings is null ? throw new NoResult() : new PrintSetup(printer, material, settings);
    }

    private static Printer? OfFile(ToolpathGoo goo)
    {
        if (goo.DecodedGCode is not { } file) return null;
        var own = new Printer { Flavor = file.Flavor };
        return SlicerLimits.Of(file.Settings, own) ?? own;
    }
}
