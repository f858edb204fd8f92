namespace Caterpillar.Machines;

// The closed layers at the top and the bottom of a part, and bridges.
public sealed partial record PrintSettings
{
    /// <summary>Number of solid top layers.</summary>
    public int TopLayers { get; init => field = Keys.Check(value); } = 4;

    /// <summary>Number of solid bottom layers.</summary>
    public int BottomLayers { get; init => field = Keys.Check(value); } = 4;

    /// <summary>Minimum thickness of solid top layers. More layers are added if they are thinner.</summary> <value>mm.</value>
    public double TopThickness { get; init => field = Keys.Check(value); } = 0.7;

    /// <summary>Minimum thickness of solid bottom layers. More layers are added if they are thinner.</summary> <value>mm.</value>
    public double BottomThickness { get; init => field = Keys.Check(value); } = 0.7;

    /// <summary>Pattern of top surfaces.</summary>
    public InfillPattern TopPattern { get; init => field = Keys.Check(value); } = InfillPattern.Monotonic;

    /// <summary>Pattern of bottom surfaces.</summary>
    public InfillPattern BottomPattern { get; init => field = Keys.Check(value); } = InfillPattern.Monotonic;

    /// <summary>Direction of solid infill in the first layer, counterclockwise from +X. It turns by 90° each layer.</summary> <value>Degrees.</value>
    public double SolidInfillAngle { get; init => field = Keys.Check(value); } = 45;

    /// <summary>Width of solid infill and bottom surfaces; 0 = line width.</summary> <value>mm.</value>
    public double SolidInfillLineWidth { get => OfNozzle(field, 0); init => field = Keys.Check(value); }

    /// <summary>Minimum width of top and bottom surfaces. Narrower ones are left to the walls.</summary> <value>mm.</value>
    public double MinSolidWidth { get; init => field = Keys.Check(value); } = 0.2;

    /// <summary>Distance by which top and bottom solid layers extend into the infill, to anchor them.</summary> <value>mm.</value>
    public double SolidInfillExpansion { get; init => field = Keys.Check(value); } = 0.6;

    /// <summary>Make infill areas smaller than this solid.</summary> <value>mm².</value>
    public double SolidInfillThresholdArea { get; init => field = Keys.Check(value); } = 10;

    /// <summary>Fill internal solid areas narrower than this along their outline; 0 = off.</summary> <value>mm.</value>
    public double NarrowSolidInfill { get; init => field = Keys.Check(value); } = 4;

    /// <summary>Speed of top surfaces; 0 = outer wall speed.</summary> <value>mm/s.</value>
    public double TopSurfaceSpeed { get; init => field = Keys.Check(value); }

    /// <summary>Speed of solid infill; 0 = infill speed.</summary> <value>mm/s.</value>
    public double SolidInfillSpeed { get; init => field = Keys.Check(value); }

    /// <summary>Iron top surfaces: the hot nozzle passes over them again with little flow.</summary>
    public bool Ironing { get; init; }

    /// <summary>Distance between ironing lines.</summary> <value>mm.</value>
    public double IroningSpacing { get; init => field = Keys.Check(value); } = 0.1;

    /// <summary>Ironing flow, in % of a full layer.</summary> <value>%.</value>
    public double IroningFlowPercent { get; init => field = Keys.Check(value); } = 10;

    /// <summary>Ironing speed; 0 = printing speed.</summary> <value>mm/s.</value>
    public double IroningSpeed { get; init => field = Keys.Check(value); } = 15;

    /// <summary>Detect bridges and print them in the direction that holds best.</summary>
    public bool Bridges { get; init; } = true;

    /// <summary>Length by which bridges overlap the material that anchors them.</summary> <value>mm.</value>
    public double BridgeAnchor { get; init => field = Keys.Check(value); } = 1;

    /// <summary>Bridge flow ratio.</summary>
    public double BridgeFlowRatio { get; init => field = Keys.Check(value); } = 1;

    /// <summary>Bridge speed; 0 = printing speed.</summary> <value>mm/s.</value>
    public double BridgeSpeed { get; init => field = Keys.Check(value); } = 25;

    /// <summary>Fan speed for bridges.</summary> <value>%.</value>
    public double BridgeFanSpeedPercent { get; init => field = Keys.Check(value); } = 100;

    /// <summary>Print the first solid layer over sparse infill as a bridge, across the infill lines.</summary>
    public bool InfillBridges { get; init; } = true;

    /// <summary>Flow ratio of bridges over infill.</summary>
    public double InfillBridgeFlowRatio { get; init => field = Keys.Check(value); } = 1;

    /// <summary>Speed of bridges over infill; 0 = bridge speed.</summary> <value>mm/s.</value>
    public double InfillBridgeSpeed { get; init => field = Keys.Check(value); } = 40;

    /// <summary>Flow ratio of a part, or of the region that a modifier covers.</summary>
    public double PartFlowRatio { get; init => field = Keys.Check(value); } = 1;

    /// <summary>Speed, fan and flow of overhanging walls: a list of [% of the width that overhangs, mm/s (0 = unchanged), fan %, flow ratio].</summary>
    public ValueList<OverhangClass> OverhangClasses { get; init => field = Keys.Check(value); } = OverhangClass.Usual;
}
