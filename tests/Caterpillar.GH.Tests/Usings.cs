global using Rg = Rhino.Geometry;
