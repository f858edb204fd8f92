namespace Caterpillar.GH.Conversion;

/// <summary>The units of the Rhino document relative to mm, the unit of the library. A document without units is in mm.</summary>
internal readonly struct DocumentUnits
{
    private const double MillimetersPerMeter = 1000;

    private DocumentUnits(double toMillimeters, string name)
    {
        var known = toMillimeters > 0 && !double.IsInfinity(toMillimeters);
        ToMillimeters = known ? toMillimeters : 1;
        Name = known ? name : "mm";
    }

    /// <summary>Units of the active document, mm without a document.</summary>
    public static DocumentUnits Current => RhinoDoc.ActiveDoc is { } document ? Of(document) : Of(UnitSystem.Millimeters);

    /// <summary>mm per document unit.</summary>
    public double ToMillimeters { get; }

    /// <summary>Document units per mm.</summary>
    public double FromMillimeters => 1 / ToMillimeters;

    public string Name { get; }

    public bool AreMillimeters => ToMillimeters == 1;

    /// <summary>Those of a document.</summary>
    public static DocumentUnits Of(RhinoDoc document)
    {
        var system = document.ModelUnitSystem;
        return system == UnitSystem.CustomUnits && document.GetCustomUnitSystem(true, out var name, out var meters)
            ? new DocumentUnits(meters * MillimetersPerMeter, name)
            : Of(system);
    }

    private static DocumentUnits Of(UnitSystem system) => new(RhinoMath.UnitScale(system, UnitSystem.Millimeters), system.ToString().ToLowerInvariant());
}
