using System.Collections.Generic;
using K = Caterpillar.Machines.Keys<Caterpillar.Machines.PrintSettings>;

namespace Caterpillar.Machines;

/// <summary>Keys of print settings: how wide walls are, and whether they have arcs.</summary>
internal static class WallWidthKeys
{
    public static readonly ProfileKey<PrintSettings, bool> VariableWallWidth = K.Boolean(
        "variable_wall_width", s => s.VariableWallWidth, (s, v) => s with { VariableWallWidth = v },
        "Walls follow the local thickness: thin places get one strand, others an even number that shares what is there. Otherwise all walls have the line"
        + " width, and what is too narrow for one stays open.");

    public static readonly ProfileKey<PrintSettings, double> MinWallWidth = K.NumberOrZero(
        "min_wall_width_mm", 0.01, 1000, s => s.MinWallWidth, (s, v) => s with { MinWallWidth = v },
        "Width of the narrowest wall where widths vary; 0 for 45 % of the line width. Places of less than half of it are not printed.");

    public static readonly ProfileKey<PrintSettings, double> MaxWallWidth = K.NumberOrZero(
        "max_wall_width_mm", 0.01, 1000, s => s.MaxWallWidth, (s, v) => s with { MaxWallWidth = v },
        "Width of the widest wall where widths vary; 0 for 180 % of the line width.");

    public static readonly ProfileKey<PrintSettings, double> WallArcTolerance = K.NumberOrZero(
        "wall_arc_tolerance_mm", 0.001, 1, s => s.WallArcTolerance, (s, v) => s with { WallArcTolerance = v },
        "Walls of planar layers become arcs (G2, G3) where they stay within this distance of one; 0 for straight segments only.");

    public static readonly IReadOnlyList<ProfileKey<PrintSettings>> All = [VariableWallWidth, MinWallWidth, MaxWallWidth, WallArcTolerance];
}
