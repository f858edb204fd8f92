using System.Collections.Generic;
using K = Caterpillar.Machines.Keys<Caterpillar.Machines.PrintSettings>;

namespace Caterpillar.Machines;

/// <summary>Keys of print settings: what is printed around and below a part.</summary>
internal static class BedKeys
{
    public static readonly ProfileKey<PrintSettings, int> SkirtLoops = K.Integer(
        "skirt_loops", 0, 1000, s => s.SkirtLoops, (s, v) => s with { SkirtLoops = v },
        "Loops around the first layer; 0 for none.");

    public static readonly ProfileKey<PrintSettings, double> SkirtDistance = K.Number(
        "skirt_distance_mm", 0, 1000, s => s.SkirtDistance, (s, v) => s with { SkirtDistance = v },
        "Distance of the skirt from the part.");

    public static readonly ProfileKey<PrintSettings, double> BrimWidth = K.Number(
        "brim_width_mm", 0, 1000, s => s.BrimWidth, (s, v) => s with { BrimWidth = v },
        "Width of a brim, which holds the first layer on the bed; 0 for none.");

    public static readonly ProfileKey<PrintSettings, BrimSide> BrimSide = K.Choice(
        "brim_side", s => s.BrimSide, (s, v) => s with { BrimSide = v },
        "On which side of the outlines the brim lies: around the part, in its holes, or both.",
        ("outside", Machines.BrimSide.Outside), ("inside", Machines.BrimSide.Inside), ("both", Machines.BrimSide.Both));

    public static readonly ProfileKey<PrintSettings, double> BrimGap = K.Number(
        "brim_gap_mm", 0, 1000, s => s.BrimGap, (s, v) => s with { BrimGap = v },
        "Distance of the brim from the part.");

    public static readonly ProfileKey<PrintSettings, int> RaftLayers = K.Integer(
        "raft_layers", 0, 1000, s => s.RaftLayers, (s, v) => s with { RaftLayers = v },
        "Layers of a raft below the part; 0 for none.");

    public static readonly ProfileKey<PrintSettings, double> RaftMargin = K.Number(
        "raft_margin_mm", 0, 1000, s => s.RaftMargin, (s, v) => s with { RaftMargin = v },
        "How far a raft reaches beyond the part.");

    public static readonly ProfileKey<PrintSettings, double> RaftHeight = K.Number(
        "raft_height_mm", 0.001, 1000, s => s.RaftHeight, (s, v) => s with { RaftHeight = v },
        "Thickness of a layer of the raft.");

    public static readonly ProfileKey<PrintSettings, double> RaftGap = K.Number(
        "raft_gap_mm", 0, 1000, s => s.RaftGap, (s, v) => s with { RaftGap = v },
        "Air between the raft and the part.");

    public static readonly ProfileKey<PrintSettings, double> RaftPercent = K.Number(
        "raft_percent", 1, 100, s => s.RaftPercent, (s, v) => s with { RaftPercent = v },
        "How much of the lower layers of the raft is filled; the uppermost one is closed.");

    public static readonly IReadOnlyList<ProfileKey<PrintSettings>> All =
    [
        SkirtLoops, SkirtDistance, BrimWidth, BrimSide, BrimGap, RaftLayers, RaftMargin, RaftHeight, RaftGap,
        RaftPercent,
    ];
}
