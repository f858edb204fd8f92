using Rhino;

namespace Caterpillar.GH.Conversion;

/// <summary>The units of the Rhino document relative to mm, the unit of the library.</summary>
internal readonly struct DocumentUnits
{
    private DocumentUnits(UnitSystem system)
    {
        ToMillimeters = RhinoMath.UnitScale(system, UnitSystem.Millimeters);
        Name = system.ToString().ToLowerInvariant();
    }

    /// <summary>Those of the active document; mm if there is none.</summary>
    public static DocumentUnits Current => RhinoDoc.ActiveDoc is { } document ? Of(document) : new(UnitSystem.Millimeters);

    /// <summary>Those of a document.</summary>
    public static DocumentUnits Of(RhinoDoc document) => new(document.ModelUnitSystem);

    /// <summary>mm per document unit.</summary>
    public double ToMillimeters { get; }

    /// <summary>Document units per mm.</summary>
    public double FromMillimeters => 1 / ToMillimeters;

    public string Name { get; }

    public bool AreMillimeters => ToMillimeters == 1;
}
