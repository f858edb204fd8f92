namespace Caterpillar.Machines;

/// <summary>
/// The extrusion model: the one place that converts between values of E, areas of extrusions and the three notations of extrusion. Internally it uses
/// the area of the extrusion in mm².
/// <list type="bullet">
/// <item>E factor (ExtruderTurtle): mm of filament per mm of path, <c>E = L · k</c>.</item>
/// <item>Area (Kanada): <c>E = L · A / (π (D/2)²)</c>.</item>
/// <item>Width × height × multiplier (Caterpillar 2019): <c>E = H · W · L · M / ((D/2)² π)</c>.</item>
/// </list>
/// Volumetric firmware takes mm³. The plunger of a clay printer is a filament of a large diameter. A pen has no E.
/// </summary>
public sealed record ExtrusionModel
{
    /// <summary>Default of ExtruderTurtle's E factor.</summary>
    public const double DefaultFactor = 0.05;

    /// <param name="unit">Unit of E.</param>
    /// <param name="filamentDiameter">Diameter of filament or plunger, mm.</param>
    /// <param name="multiplier">Flow ratio: scales all E.</param>
    /// <exception cref="ArgumentOutOfRangeException">The diameter or the multiplier is not positive and finite.</exception>
    public ExtrusionModel(ExtrusionUnit unit, double filamentDiameter, double multiplier = 1)
    {
        Unit = unit;
        FilamentDiameter = Positive(filamentDiameter, nameof(filamentDiameter));
        Multiplier = Positive(multiplier, nameof(multiplier));
    }

    /// <summary>Unit of E.</summary>
    public ExtrusionUnit Unit { get; }

    /// <summary>Diameter of the filament or plunger, mm.</summary>
    public double FilamentDiameter { get; }

    /// <summary>Flow ratio: scales <see cref="E"/>, but not the intended volume.</summary>
    public double Multiplier { get; }

    /// <summary>Cross-section of the filament or plunger, mm².</summary>
    public double FilamentArea => FilamentAreaOf(FilamentDiameter);

    /// <summary>mm³ that the machine feeds per unit of E; null without E.</summary>
    internal double? FedVolumePerE => Unit switch
    {
        ExtrusionUnit.Mm => FilamentArea,
        ExtrusionUnit.Mm3 => 1,
        _ => null,
    };

    /// <summary>mm³ of extrusion per unit of E, with the multiplier (as in <c>ToolpathTool.VolumePerE</c>); null without E.</summary>
    public double? VolumePerE => FedVolumePerE / Multiplier;

    /// <summary>mm of filament per unit of E; 1 for a pen.</summary>
    public double FilamentPerE => Unit == ExtrusionUnit.Mm3 ? 1 / FilamentArea : 1;

    /// <summary>
    /// E for a path length in mm and an extrusion area in mm²; 0 without E. The sign of the length does not matter, since backward moves extrude too.
    /// </summary>
    public double E(double length, double area) => VolumePerE is { } volume ? Math.Abs(length) * area / volume : 0;

    /// <summary>E for mm of filament, the unit of retractions.</summary>
    public double EOfFilament(double millimeters) => Unit switch
    {
        ExtrusionUnit.Mm => millimeters,
        ExtrusionUnit.Mm3 => millimeters * FilamentArea,
        _ => 0,
    };

    /// <summary>Extrusion area in mm² for ExtruderTurtle's E factor (mm of filament per mm of path).</summary>
    public double AreaOfFactor(double factor) => factor * FilamentArea;

    /// <summary>ExtruderTurtle's E factor (mm of filament per mm of path) for an extrusion area in mm².</summary>
    public double FactorOfArea(double area) => area / FilamentArea;

    /// <summary>Cross-section in mm² of a filament or plunger, for a diameter in mm.</summary>
    public static double FilamentAreaOf(double diameter) => Math.PI / 4 * diameter * diameter;

    private static double Positive(double value, string name)
        => value > 0 && !double.IsInfinity(value) ? value : throw new ArgumentOutOfRangeException(name, value, "Must be positive and finite.");
}
