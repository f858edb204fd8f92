namespace Caterpillar.Machines;

/// <summary>
/// What is extruded. The keys of profiles are in <see cref="ProfileKeys"/>; a value outside its key's range throws an
/// <see cref="System.ArgumentOutOfRangeException"/>. Immutable.
/// </summary>
public sealed record Material
{
    /// <summary>Name of the profile.</summary>
    public string Name { get; init; } = "pla";

    /// <summary>Display name.</summary>
    public string Title { get; init => field = MaterialKeys.Title.Check(value); } = "PLA";

    /// <summary>Diameter of the filament, or of the plunger whose travel E measures, mm.</summary>
    public double FilamentDiameter { get; init => field = MaterialKeys.FilamentDiameter.Check(value); } = 1.75;

    /// <summary>°C; 0 = off.</summary>
    public double NozzleTemperature { get; init => field = MaterialKeys.NozzleTemperature.Check(value); } = 210;

    /// <summary>Nozzle temperature of the first layer, °C; 0 for <see cref="NozzleTemperature"/>.</summary>
    public double FirstLayerNozzleTemperature { get; init => field = MaterialKeys.FirstLayerNozzleTemperature.Check(value); }

    /// <summary>°C; 0 = off.</summary>
    public double BedTemperature { get; init => field = MaterialKeys.BedTemperature.Check(value); } = 60;

    /// <summary>Scales all E: 1 for material that fills exactly the requested bead.</summary>
    public double FlowMultiplier { get; init => field = MaterialKeys.FlowMultiplier.Check(value); } = 1;

    /// <summary>Part cooling, 0 to 100 %.</summary>
    public double FanPercent { get; init => field = MaterialKeys.FanPercent.Check(value); } = 100;

    /// <summary>Part cooling of the quickest layers, %.</summary>
    public double FanMaxPercent { get; init => field = MaterialKeys.FanMaxPercent.Check(value); } = 100;

    /// <summary>Layers that take less time than this get more part cooling, s; 0 for the same in all layers.</summary>
    public double FanLayerTime { get; init => field = MaterialKeys.FanLayerTime.Check(value); }

    /// <summary>Number of first layers that are printed without part cooling.</summary>
    public int FanOffLayers { get; init => field = MaterialKeys.FanOffLayers.Check(value); } = 1;

    /// <summary>g/cm³.</summary>
    public double Density { get; init => field = MaterialKeys.Density.Check(value); } = 1.24;

    /// <summary>Price of a kilogram in any currency; 0 if unknown.</summary>
    public double CostPerKg { get; init => field = MaterialKeys.CostPerKg.Check(value); }

    /// <summary>mm³/s; 0 if unknown.</summary>
    public double MaxFlow { get; init => field = MaterialKeys.MaxFlow.Check(value); }

    public override string ToString() => Title;
}
