using System.Collections.Generic;
using Caterpillar.GH.Goos;
using Caterpillar.GH.Params;
using Caterpillar.GH.Plugin;
using Caterpillar.Machines;
using Caterpillar.Simulation;

namespace Caterpillar.GH.Base;

/// <summary>The printer, material and settings of a toolpath: from ports, else from its plan, else from the file it was decoded from.</summary>
internal static class SetupPorts
{
    public static void Printer(InputPorts ports) => ports.Add(new PrinterParam(), "Printer", "P",
        "Printer, or the name of its profile; by default the one it was planned for, the limits in its file, or the generic one.", optional: true);

    /// <summary>The setup for a printer, or null for that of the toolpath.</summary>
    public static PrintSetup Of(Run run, ToolpathGoo goo, Printer? printer, Material? material = null, PrintSettings? settings = null,
        List<string>? texts = null)
    {
        var planned = goo.Setup;
        var target = printer ?? planned?.Printer ?? OfFile(goo) ?? new Printer();
        return new PrintSetup(target,
            material ?? planned?.Material ?? run.Accept(Profiles.Library.Material(target.DefaultMaterial), texts) ?? new Material(),
            settings ?? planned?.Settings ?? run.Accept(Profiles.Library.Settings(target.DefaultSettings), texts) ?? new PrintSettings())
        { PrintedOn = planned?.PrintedOn };
    }

    private static Printer? OfFile(ToolpathGoo goo)
    {
        if (goo.DecodedGCode is not { } file) return null;
        var own = new Printer { Dialect = file.Dialect };
        return SlicerLimits.Of(file.Settings, own) ?? own;
    }
}
