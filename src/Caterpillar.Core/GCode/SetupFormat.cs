using System;
using Caterpillar.Basics;
using Caterpillar.Machines;
using Caterpillar.Toolpaths;

namespace Caterpillar.GCode;

/// <summary>The format in which a printer wants its G-code.</summary>
public static class SetupFormat
{
    /// <summary>Dialect, mode of E and decimals of the printer.</summary>
    public static Result<GCodeFormat> Of(PrintSetup setup, Toolpath toolpath)
    {
        if (setup is null) throw new ArgumentNullException(nameof(setup));
        if (toolpath is null) throw new ArgumentNullException(nameof(toolpath));
        var printer = setup.Printer;
        return new Result<GCodeFormat>(new GCodeFormat
        {
            Dialect = printer.Dialect,
            RelativeE = printer.ExtrusionMode == ExtrusionMode.Relative,
            DecimalsXyz = printer.DecimalsXyz,
            DecimalsE = printer.DecimalsE,
            DecimalsF = printer.DecimalsF,
            FirmwareRetraction = printer.FirmwareRetraction,
            HasE = printer.ExtrusionUnit != ExtrusionUnit.None,
        }, []);
    }
}
