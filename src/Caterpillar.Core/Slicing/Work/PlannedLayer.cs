namespace Caterpillar.Slicing;

/// <summary>A planar layer before it is cut.</summary>
/// <param name="Top">Height of its top above the bed, mm.</param>
/// <param name="Thickness">mm.</param>
/// <param name="Cut">Height at which the mesh is cut, mm.</param>
internal readonly record struct PlannedLayer(double Top, double Thickness, double Cut);
