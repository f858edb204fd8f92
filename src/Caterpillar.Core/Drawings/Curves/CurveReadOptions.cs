using Caterpillar.Basics;
using Caterpillar.Machines;

namespace Caterpillar.Drawings;

/// <summary>What percentages in curve files refer to; 0 if unknown, so that percentages are errors.</summary>
public sealed record CurveReadOptions
{
    /// <summary>100 % of a width, mm: the diameter of the nozzle.</summary>
    public double WidthReference { get; init; }

    /// <summary>100 % of a height, mm: that of the layer.</summary>
    public double HeightReference { get; init; }

    /// <summary>100 % of a speed, mm/s.</summary>
    public double SpeedReference { get; init; }

    /// <summary>mm per unit of CSV, JSON and OBJ, which state none (JSON may: <c>"units"</c>).</summary>
    public double UnitLength { get; init; } = 1;

    /// <summary>How much memory the unpacked file may take; more is the error <see cref="MemoryLimit.Code"/>.</summary>
    public MemoryLimit Memory { get; init; } = MemoryLimit.Default;

    /// <summary>Percentages refer to the nozzle, layers and speed of a setup.</summary>
    public static CurveReadOptions For(PrintSetup setup)
    {
        if (setup is null) throw new ArgumentNullException(nameof(setup));
        return new CurveReadOptions
        {
            WidthReference = setup.Printer.NozzleDiameter, HeightReference = setup.Settings.LayerHeight, SpeedReference = setup.Settings.PrintSpeed,
        };
    }
}
