using Rhino;

namespace Caterpillar.GH.Conversion;

/// <summary>The units of the Rhino document against mm, in which the library works.</summary>
internal readonly struct DocumentUnits
{
    private DocumentUnits(UnitSystem system)
    {
        ToMillimeters = RhinoMath.UnitScale(system, UnitSystem.Millimeters);
        Name = system.ToString().ToLowerInvariant();
    }

    /// <summary>Those of the active document; mm where there is none.</summary>
    public static DocumentUnits Current => new(RhinoDoc.ActiveDoc is { } document ? document.ModelUnitSystem : UnitSystem.Millimeters);

    /// <summary>mm per document unit.</summary>
    public double ToMillimeters { get; }

    /// <summary>Document units per mm.</summary>
    public double FromMillimeters => 1 / ToMillimeters;

    public string Name { get; }

    public bool AreMillimeters => ToMillimeters == 1;
}
