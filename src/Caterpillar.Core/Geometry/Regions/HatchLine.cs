namespace Caterpillar.Geometry;

/// <summary>A part of a hatch line.</summary>
/// <param name="Row">Row number. The distance of the row from the origin is phase + row · spacing.</param>
/// <param name="From">Start in mm, at Z = 0.</param>
/// <param name="To">End in mm, in the direction of the hatch lines.</param>
public readonly record struct HatchLine(int Row, Vec3 From, Vec3 To);
