namespace Caterpillar.Geometry;

/// <summary>A piece of a hatch line.</summary>
/// <param name="Row">Number of the line: its distance from the origin is phase + row · spacing.</param>
/// <param name="From">Start in mm, at Z 0.</param>
/// <param name="To">End in mm, in the direction of the hatch.</param>
public readonly record struct HatchLine(int Row, Vec3 From, Vec3 To);
