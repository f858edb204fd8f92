namespace Caterpillar.Machines;

// The closed layers at the top and the bottom of a part, and bridges.
public sealed partial record PrintSettings
{
    /// <summary>Closed layers below every surface that is seen from above.</summary>
    public int TopLayers { get; init => field = SkinKeys.TopLayers.Check(value); } = 4;

    /// <summary>Closed layers above every surface that is seen from below.</summary>
    public int BottomLayers { get; init => field = SkinKeys.BottomLayers.Check(value); } = 4;

    /// <summary>Least thickness of the closed layers at the top; more layers are closed where they are thin, mm.</summary>
    public double TopThickness { get; init => field = SkinKeys.TopThickness.Check(value); } = 0.7;

    /// <summary>Least thickness of the closed layers at the bottom; more layers are closed where they are thin, mm.</summary>
    public double BottomThickness { get; init => field = SkinKeys.BottomThickness.Check(value); } = 0.7;

    /// <summary>Lines of the surfaces seen from above.</summary>
    public InfillPattern TopPattern { get; init => field = SkinKeys.TopPattern.Check(value); } = InfillPattern.Monotonic;

    /// <summary>Lines of the surfaces seen from below.</summary>
    public InfillPattern BottomPattern { get; init => field = SkinKeys.BottomPattern.Check(value); } = InfillPattern.Monotonic;

    /// <summary>Direction of the skins in the first layer, from +X; it turns by a quarter from layer to layer, degrees.</summary>
    public double SkinAngle { get; init => field = SkinKeys.SkinAngle.Check(value); } = 45;

    /// <summary>Width of the strands of the skins; 0 for the line width, mm.</summary>
    public double SkinWidth { get; init => field = SkinKeys.SkinWidth.Check(value); }

    /// <summary>Skins narrower than this are left to the walls, mm.</summary>
    public double SkinMinWidth { get; init => field = SkinKeys.SkinMinWidth.Check(value); } = 0.2;

    /// <summary>How far skins reach into the infill, which holds them there, mm.</summary>
    public double SkinExpand { get; init => field = SkinKeys.SkinExpand.Check(value); } = 0.6;

    /// <summary>Pieces of infill smaller than this area are made solid, mm².</summary>
    public double SolidBelow { get; init => field = SkinKeys.SolidBelow.Check(value); } = 10;

    /// <summary>Closed areas inside that are narrower than this are filled along their outline, mm; 0 for lines everywhere.</summary>
    public double NarrowSolid { get; init => field = SkinKeys.NarrowSolid.Check(value); } = 4;

    /// <summary>Speed of the surfaces seen from above, mm/s; 0 for the speed of outer walls.</summary>
    public double TopSkinSpeed { get; init => field = SkinKeys.TopSkinSpeed.Check(value); }

    /// <summary>Speed of the other closed layers, mm/s; 0 for the speed of the infill.</summary>
    public double SolidInfillSpeed { get; init => field = SkinKeys.SolidInfillSpeed.Check(value); }

    /// <summary>The hot nozzle goes over surfaces seen from above once more, with little material, and smooths them.</summary>
    public bool Ironing { get; init; }

    /// <summary>Distance between the lines of ironing, mm.</summary>
    public double IroningSpacing { get; init => field = SkinKeys.IroningSpacing.Check(value); } = 0.1;

    /// <summary>Material of ironing, of what would fill its layer, %.</summary>
    public double IroningFlowPercent { get; init => field = SkinKeys.IroningFlowPercent.Check(value); } = 10;

    /// <summary>Speed of ironing, mm/s; 0 for the print speed.</summary>
    public double IroningSpeed { get; init => field = SkinKeys.IroningSpeed.Check(value); } = 15;

    /// <summary>Skins over air are spanned in the direction in which they are held best.</summary>
    public bool Bridges { get; init; } = true;

    /// <summary>How far a bridge lies on what holds it, mm.</summary>
    public double BridgeAnchor { get; init => field = SkinKeys.BridgeAnchor.Check(value); } = 1;

    /// <summary>Material of bridges, of that of the other strands.</summary>
    public double BridgeFlow { get; init => field = SkinKeys.BridgeFlow.Check(value); } = 1;

    /// <summary>Speed of bridges, mm/s; 0 for the print speed.</summary>
    public double BridgeSpeed { get; init => field = SkinKeys.BridgeSpeed.Check(value); } = 25;

    /// <summary>Fan while a bridge is printed, %.</summary>
    public double BridgeFanPercent { get; init => field = SkinKeys.BridgeFanPercent.Check(value); } = 100;

    /// <summary>The first closed layer over sparse infill is printed across its lines, as bridges are.</summary>
    public bool InfillBridges { get; init; } = true;

    /// <summary>Material of bridges over infill, of that of the other strands.</summary>
    public double InfillBridgeFlow { get; init => field = SkinKeys.InfillBridgeFlow.Check(value); } = 1;

    /// <summary>Speed of bridges over infill, mm/s; 0 for the speed of bridges.</summary>
    public double InfillBridgeSpeed { get; init => field = SkinKeys.InfillBridgeSpeed.Check(value); } = 40;

    /// <summary>Material of all strands of a part, of the usual.</summary>
    public double PartFlow { get; init => field = SkinKeys.PartFlow.Check(value); } = 1;

    /// <summary>Walls over air, classed by the percentage of their width that hangs over.</summary>
    public ValueList<OverhangClass> OverhangClasses { get; init => field = SkinKeys.OverhangClasses.Check(value); } = OverhangClass.Usual;
}
