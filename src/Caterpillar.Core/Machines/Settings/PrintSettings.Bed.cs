namespace Caterpillar.Machines;

// What is printed around and below a part.
public sealed partial record PrintSettings
{
    /// <summary>Number of skirt loops; 0 = off.</summary>
    public int SkirtLoops { get; init => field = Keys.Check(value); }

    /// <summary>Distance of the skirt from the part.</summary> <value>mm.</value>
    public double SkirtDistance { get; init => field = Keys.Check(value); } = 5;

    /// <summary>Brim width; 0 = off.</summary> <value>mm.</value>
    public double BrimWidth { get; init => field = Keys.Check(value); }

    /// <summary>Brim around the part, inside its holes, both, or only ears at its corners.</summary>
    public BrimType BrimType { get; init; }

    /// <summary>With brim_type=ears: outer corners up to this angle have ears.</summary> <value>Degrees.</value>
    public double BrimEarsMaxAngle { get; init => field = Keys.Check(value); } = 125;

    /// <summary>Brim ears at points of the bed, with any brim_type: a list of [x, y, diameter].</summary> <value>mm.</value>
    public ValueList<BrimEar> BrimEars { get; init => field = Keys.Check(value); } = ValueList<BrimEar>.Empty;

    /// <summary>Gap between brim and part.</summary> <value>mm.</value>
    public double BrimGap { get; init => field = Keys.Check(value); }

    /// <summary>Whether something is printed on the bed around the part.</summary>
    internal bool HasSkirtOrBrim => SkirtLoops > 0 || BrimWidth > 0 || BrimEars.Count > 0;

    /// <summary>The settings without skirt, brim and ears.</summary>
    internal PrintSettings WithoutSkirtAndBrim => this with { SkirtLoops = 0, BrimWidth = 0, BrimEars = ValueList<BrimEar>.Empty };

    /// <summary>Number of raft layers; 0 = off.</summary>
    public int RaftLayers { get; init => field = Keys.Check(value); }

    /// <summary>Distance by which the raft extends beyond the part.</summary> <value>mm.</value>
    public double RaftExpansion { get; init => field = Keys.Check(value); } = 3;

    /// <summary>Layer height of the raft; 0 = 75 % of the nozzle diameter.</summary> <value>mm.</value>
    public double RaftLayerHeight { get => OfNozzle(field, 0.3); init => field = Keys.Check(value); }

    /// <summary>Gap between raft and part.</summary> <value>mm.</value>
    public double RaftGap { get; init => field = Keys.Check(value); } = 0.2;

    /// <summary>Density of the lower raft layers. The top layer is solid.</summary> <value>%.</value>
    public double RaftDensityPercent { get; init => field = Keys.Check(value); } = 40;
}
