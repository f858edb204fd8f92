using Caterpillar.Toolpaths;

namespace Caterpillar.Machines;

/// <summary>
/// Print settings. Lengths in mm, speeds in mm/s. The keys of profiles are in <see cref="ProfileKeys"/>; a value outside its key's range throws an
/// <see cref="System.ArgumentOutOfRangeException"/>. Immutable.
/// </summary>
public sealed partial record PrintSettings
{
    /// <summary>Name of the profile.</summary>
    public string Name { get; init; } = "standard";

    /// <summary>Display name.</summary>
    public string Title { get; init => field = SettingsKeys.Title.Check(value); } = "Standard";

    /// <summary>mm.</summary>
    public double LayerHeight { get; init => field = SettingsKeys.LayerHeight.Check(value); } = 0.2;

    /// <summary>Height of the layer on the bed, mm.</summary>
    public double FirstLayerHeight { get; init => field = SettingsKeys.FirstLayerHeight.Check(value); } = 0.2;

    /// <summary>Width of a strand, mm.</summary>
    public double LineWidth { get; init => field = SettingsKeys.LineWidth.Check(value); } = 0.45;

    /// <summary>Shape of the cross-section, which relates area and width of a strand.</summary>
    public BeadShape BeadShape { get; init; } = BeadShape.Stadium;

    /// <summary>Walls around each region.</summary>
    public int WallCount { get; init => field = SettingsKeys.WallCount.Check(value); } = 2;

    /// <summary>Share of the inside that is filled, %; ignored if <see cref="InfillSpacing"/> is given.</summary>
    public double InfillPercent { get; init => field = SettingsKeys.InfillPercent.Check(value); } = 20;

    /// <summary>Distance between the lines of the infill, mm (the "density" of Caterpillar 2019); 0 to take it from <see cref="InfillPercent"/>.</summary>
    public double InfillSpacing { get; init => field = SettingsKeys.InfillSpacing.Check(value); }

    /// <summary>Direction of the infill in the first layer, degrees from +X.</summary>
    public double InfillAngle { get; init => field = SettingsKeys.InfillAngle.Check(value); } = 45;

    /// <summary>Overlap of the infill with the innermost wall, % of the line width; lines of closed areas overlap by two thirds of it.</summary>
    public double InfillOverlapPercent { get; init => field = SettingsKeys.InfillOverlapPercent.Check(value); } = 15;

    /// <summary>Maximum deviation of simplified contours, mm.</summary>
    public double SimplifyTolerance { get; init => field = SettingsKeys.SimplifyTolerance.Check(value); } = 0.0125;

    /// <summary>Models that run through each other are printed as one solid.</summary>
    public bool MergeOverlapping { get; init; } = true;

    /// <summary>Several models are printed layer by layer, or one after the other.</summary>
    public PrintSequence PrintSequence { get; init; } = PrintSequence.ByLayer;

    /// <summary>Meshes that are not closed are made solid before they are sliced.</summary>
    public bool MendMeshes { get; init; } = true;

    /// <summary>Gaps in the contours of broken meshes are closed up to this width, mm; 0 closes none.</summary>
    public double LargestGap { get; init => field = SettingsKeys.LargestGap.Check(value); } = 10;

    /// <summary>A layer of a broken mesh that loses more than this of the area of its neighbors is an error, %; 100 allows any loss.</summary>
    public double MaxAreaLossPercent { get; init => field = SettingsKeys.MaxAreaLossPercent.Check(value); } = 25;

    /// <summary>Length of the pieces of subdivided curves, mm.</summary>
    public double SubdivisionDistance { get; init => field = SettingsKeys.SubdivisionDistance.Check(value); } = 1;

    /// <summary>mm/s.</summary>
    public double PrintSpeed { get; init => field = SettingsKeys.PrintSpeed.Check(value); } = 60;

    /// <summary>Speed of outer walls, mm/s; 0 for <see cref="PrintSpeed"/>.</summary>
    public double OuterWallSpeed { get; init => field = SettingsKeys.OuterWallSpeed.Check(value); } = 40;

    /// <summary>Speed of infill, mm/s; 0 for <see cref="PrintSpeed"/>.</summary>
    public double InfillSpeed { get; init => field = SettingsKeys.InfillSpeed.Check(value); }

    /// <summary>Maximum print speed in the first layer, mm/s; 0 for no limit.</summary>
    public double FirstLayerSpeed { get; init => field = SettingsKeys.FirstLayerSpeed.Check(value); } = 25;

    /// <summary>mm/s.</summary>
    public double TravelSpeed { get; init => field = SettingsKeys.TravelSpeed.Check(value); } = 150;

    /// <summary>How high the head rises before travels.</summary>
    public TravelLift TravelLift { get; init; } = TravelLift.PrintedTop;

    /// <summary>Travels up to this length are made without a lift, mm.</summary>
    public double LiftMinTravel { get; init => field = SettingsKeys.LiftMinTravel.Check(value); } = 2;

    /// <summary>Travels go around printed parts if that is faster than over them.</summary>
    public bool Detour { get; init; }

    /// <summary>Travels within a layer that stay inside the part are made without lift and retraction.</summary>
    public bool Comb { get; init; } = true;

    /// <summary>Travels up to this length are made without a retraction, mm.</summary>
    public double RetractionMinTravel { get; init => field = SettingsKeys.RetractionMinTravel.Check(value); } = 1.5;

    /// <summary>Distance back along the path during which filament is retracted, mm; 0 for none.</summary>
    public double WipeDistance { get; init => field = SettingsKeys.WipeDistance.Check(value); }

    /// <summary>Retracted filament is restored while the head descends to a path, not afterwards.</summary>
    public bool RestoreDuringDescent { get; init; }

    /// <summary>Length of bead that is extruded in place before a path starts, for materials with a delayed response, mm.</summary>
    public double StartDistance { get; init => field = SettingsKeys.StartDistance.Check(value); }

    /// <summary>The extruder stops this far before the end of a path, mm.</summary>
    public double StopDistance { get; init => field = SettingsKeys.StopDistance.Check(value); }

    /// <summary>Sliced paths are sorted inside their groups, for short travels.</summary>
    public bool SortPaths { get; init; } = true;

    /// <summary>Speed in mm/s of paths without their own.</summary>
    public double SpeedOf(Role role, bool firstLayer = false)
    {
        var own = role switch
        {
            Role.OuterWall => OuterWallSpeed,
            Role.TopSkin => TopSkinSpeed > 0 ? TopSkinSpeed : OuterWallSpeed,
            Role.Infill => InfillSpeed,
            Role.SolidInfill or Role.BottomSkin => SolidInfillSpeed > 0 ? SolidInfillSpeed : InfillSpeed,
            Role.Bridge => BridgeSpeed,
            Role.Ironing => IroningSpeed,
            Role.Support or Role.SupportInterface => SupportSpeed,
            _ => 0,
        };
        var speed = own > 0 ? own : PrintSpeed;
        return firstLayer && FirstLayerSpeed > 0 && FirstLayerSpeed < speed ? FirstLayerSpeed : speed;
    }

    public override string ToString() => Title;
}
