namespace Caterpillar.Curved;

/// <summary>A point of a flat layer, brought back into the part.</summary>
/// <param name="Part">The point in the part, mm.</param>
/// <param name="Gap">Vertical distance to the bottom of its extrusion, mm.</param>
/// <param name="Area">Area in plan for each area among flat layers.</param>
internal readonly record struct LiftedPoint(Vec3 Part, double Gap, double Area);
