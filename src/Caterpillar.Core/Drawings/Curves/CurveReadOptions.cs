namespace Caterpillar.Drawings;

/// <summary>References for percentages in curve files; 0 = unknown (percentages are errors).</summary>
public sealed record CurveReadOptions
{
    /// <summary>Width at 100 %, mm: the nozzle diameter.</summary>
    public double WidthReference { get; init; }

    /// <summary>Height at 100 %, mm: the layer height.</summary>
    public double HeightReference { get; init; }

    /// <summary>Speed at 100 %, mm/s.</summary>
    public double SpeedReference { get; init; }

    /// <summary>mm per unit of CSV, OBJ, and JSON without <c>"units"</c>.</summary>
    public double UnitLength { get; init; } = 1;

    /// <summary>Maximum memory of the unpacked file. More is the error <see cref="MemoryLimit.Code"/>.</summary>
    public MemoryLimit Memory { get; init; } = MemoryLimit.Default;

    /// <summary>References from a setup: its nozzle diameter, layer height and printing speed.</summary>
    public static CurveReadOptions For(PrintSetup setup)
    {
        if (setup is null) throw new ArgumentNullException(nameof(setup));
        return new CurveReadOptions
        {
            WidthReference = setup.Printer.NozzleDiameter, HeightReference = setup.Settings.LayerHeight, SpeedReference = setup.Settings.PrintSpeed,
        };
    }
}
