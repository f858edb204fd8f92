// The one rule for names that Rhino and the library share (Curve, Polyline, Arc, Plane …): Rhino's geometry is always written Rg.Name, the library's without a
// prefix.
global using Rg = Rhino.Geometry;
