namespace Caterpillar.Toolpaths;

/// <summary>One layer of an object. Layers of several objects, and curved or variable layers, may have the same height.</summary>
/// <param name="Index">Number of the layer within its object, from 0.</param>
/// <param name="Z">Nominal height of its top above the bed, mm.</param>
/// <param name="Thickness">Nominal thickness, mm. 0 = unknown.</param>
/// <param name="Object">Name of the object, or empty.</param>
public sealed record Layer(int Index, double Z, double Thickness = 0, string Object = "");
