using System.Collections.Generic;
using Caterpillar.Geometry;
using K = Caterpillar.Machines.Keys<Caterpillar.Machines.PrintSettings>;

namespace Caterpillar.Machines;

/// <summary>Keys of print settings: seams and the order of walls.</summary>
internal static class SeamKeys
{
    public static readonly ProfileKey<PrintSettings, SeamPosition> SeamPosition = K.Choice(
        "seam_position", s => s.SeamPosition, (s, v) => s with { SeamPosition = v },
        "Where outer walls begin: in a corner and above the seam of the layer below, where the head comes from, at the back, near seam_point_mm, anywhere, "
        + "or in the most concave corner of each layer.",
        ("aligned", Machines.SeamPosition.Aligned), ("nearest", Machines.SeamPosition.Nearest), ("rear", Machines.SeamPosition.Rear),
        ("point", Machines.SeamPosition.Point), ("random", Machines.SeamPosition.Random), ("corner", Machines.SeamPosition.Corner));

    public static readonly ProfileKey<PrintSettings, Vec3> SeamPoint = new(
        "seam_point_mm", new NumbersFormat<Vec3>(["x", "y"], -100_000, 100_000, n => new Vec3(n[0], n[1]), v => [v.X, v.Y]), s => s.SeamPoint,
        (s, v) => s with { SeamPoint = v }, "For seam_position point: seams lie on the side of this point of the bed.");

    public static readonly ProfileKey<PrintSettings, ValueList<SeamMark>> SeamMarks = new(
        "seam_marks_mm",
        new RowsFormat<SeamMark>(
            ["x", "y", "z", "radius"], 0, 10_000, -100_000, 100_000, SeamMark.Of, m => [m.Place.X, m.Place.Y, m.Place.Z, m.Radius], SeamMark.Problem),
        s => s.SeamMarks, (s, v) => s with { SeamMarks = v },
        "Painted places for seams: a list of balls [x, y, z, radius]; loops that pass one begin there, whatever seam_position is.");

    public static readonly ProfileKey<PrintSettings, int> SeamSeed = K.Integer(
        "seam_seed", 0, 1_000_000_000, s => s.SeamSeed, (s, v) => s with { SeamSeed = v }, "Seed of the random numbers of seam_position random.");

    public static readonly ProfileKey<PrintSettings, double> SeamGap = K.Number(
        "seam_gap_mm", 0, 10, s => s.SeamGap, (s, v) => s with { SeamGap = v },
        "So far before it has gone around a wall the extruder stops, for the strand begins round; at most a tenth of the wall. 0 for none.");

    public static readonly ProfileKey<PrintSettings, double> ScarfLength = K.NumberOrZero(
        "scarf_length_mm", 0.1, 1000, s => s.ScarfLength, (s, v) => s with { ScarfLength = v },
        "Length over which an outer wall rises at its start and runs out over that ramp at its end; 0 for a plain seam.");

    public static readonly ProfileKey<PrintSettings, int> ScarfSteps = K.Integer(
        "scarf_steps", 2, 1000, s => s.ScarfSteps, (s, v) => s with { ScarfSteps = v }, "Steps of the ramp of a scarf seam.");

    public static readonly ProfileKey<PrintSettings, WallOrder> WallOrder = K.Choice(
        "wall_order", s => s.WallOrder, (s, v) => s with { WallOrder = v },
        "Order of the walls of a contour: the outer wall last, first, or alternating from layer to layer.",
        ("inside_out", Machines.WallOrder.InsideOut), ("outside_in", Machines.WallOrder.OutsideIn), ("alternating", Machines.WallOrder.Alternating));

    public static readonly ProfileKey<PrintSettings, OverhangWallOrder> OverhangWallOrder = K.Choice(
        "overhang_wall_order", s => s.OverhangWallOrder, (s, v) => s with { OverhangWallOrder = v },
        "Order of the walls of contours that hang over the layer below somewhere.",
        ("same", Machines.OverhangWallOrder.Same), ("inside_out", Machines.OverhangWallOrder.InsideOut),
        ("outside_in", Machines.OverhangWallOrder.OutsideIn));

    public static readonly IReadOnlyList<ProfileKey<PrintSettings>> All =
    [
        SeamPosition, SeamPoint, SeamMarks, SeamSeed, SeamGap, ScarfLength, ScarfSteps, WallOrder, OverhangWallOrder,
    ];
}
