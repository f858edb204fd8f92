namespace Caterpillar.GH.Components.Slice;

/// <summary>How the layers of a curved print are given.</summary>
public enum FieldKind
{
    Vertical,
    Normal,
    Between,
    Formula,
    Cone,
    Overhangs,
    Deformed,
    Harmonic,
    Geodesic,
}
