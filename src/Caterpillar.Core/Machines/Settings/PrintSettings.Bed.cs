namespace Caterpillar.Machines;

// What is printed around and below a part.
public sealed partial record PrintSettings
{
    /// <summary>Loops around the first layer; 0 for none.</summary>
    public int SkirtLoops { get; init => field = BedKeys.SkirtLoops.Check(value); }

    /// <summary>Distance of the skirt from the part, mm.</summary>
    public double SkirtDistance { get; init => field = BedKeys.SkirtDistance.Check(value); } = 5;

    /// <summary>Width of a brim, which holds the first layer on the bed; 0 for none, mm.</summary>
    public double BrimWidth { get; init => field = BedKeys.BrimWidth.Check(value); }

    /// <summary>On which side of the outlines the brim lies: around the part, in its holes, or both.</summary>
    public BrimSide BrimSide { get; init; }

    /// <summary>Distance of the brim from the part, mm.</summary>
    public double BrimGap { get; init => field = BedKeys.BrimGap.Check(value); }

    /// <summary>Layers of a raft below the part; 0 for none.</summary>
    public int RaftLayers { get; init => field = BedKeys.RaftLayers.Check(value); }

    /// <summary>How far a raft reaches beyond the part, mm.</summary>
    public double RaftMargin { get; init => field = BedKeys.RaftMargin.Check(value); } = 3;

    /// <summary>Thickness of a layer of the raft, mm.</summary>
    public double RaftHeight { get; init => field = BedKeys.RaftHeight.Check(value); } = 0.3;

    /// <summary>Air between the raft and the part, mm.</summary>
    public double RaftGap { get; init => field = BedKeys.RaftGap.Check(value); } = 0.2;

    /// <summary>How much of the lower layers of the raft is filled; the uppermost one is closed, %.</summary>
    public double RaftPercent { get; init => field = BedKeys.RaftPercent.Check(value); } = 40;
}
