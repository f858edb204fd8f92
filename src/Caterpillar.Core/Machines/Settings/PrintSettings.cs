namespace Caterpillar.Machines;

/// <summary>
/// Print settings. Lengths in mm, speeds in mm/s. The keys of profiles are in <see cref="ProfileKeys"/>. A value outside its key's range throws an
/// <see cref="System.ArgumentOutOfRangeException"/>. Immutable.
/// </summary>
public sealed partial record PrintSettings
{
    /// <summary>Diameter of the nozzle without a printer, mm.</summary>
    internal const double UsualNozzle = 0.4;

    private static ProfileKind<PrintSettings> Keys => ProfileKinds.Settings;

    /// <summary>Name of the profile.</summary>
    public string Name { get; init; } = "standard";

    /// <summary>Display name.</summary>
    public string Title { get; init => field = Keys.Check(value); } = "Standard";

    /// <summary>Layer height; 0 = half the nozzle diameter.</summary> <value>mm.</value>
    public double LayerHeight { get => OfNozzle(field, 0.2); init => field = Keys.Check(value); }

    /// <summary>Height of the first layer; 0 = half the nozzle diameter.</summary> <value>mm.</value>
    public double FirstLayerHeight { get => OfNozzle(field, 0.2); init => field = Keys.Check(value); }

    /// <summary>The larger of both heights, mm.</summary>
    internal double LargerLayerHeight => Math.Max(LayerHeight, FirstLayerHeight);

    /// <summary>Width of extrusions; 0 = 112.5 % of the nozzle diameter.</summary> <value>mm.</value>
    public double LineWidth { get => OfNozzle(field, 0.45); init => field = Keys.Check(value); }

    /// <summary>Shape of the cross-section of an extrusion, which relates its area to its width.</summary>
    public BeadShape BeadShape { get; init; } = BeadShape.Stadium;

    /// <summary>Number of walls.</summary>
    public int WallCount { get; init => field = Keys.Check(value); } = 2;

    /// <summary>Infill density. infill_spacing_mm takes precedence.</summary> <value>%.</value>
    public double InfillDensityPercent { get; init => field = Keys.Check(value); } = 20;

    /// <summary>Distance between infill lines; 0 = from infill_density_percent.</summary>
    /// <value>mm.</value> <remarks>The "density" of Caterpillar 2019.</remarks>
    public double InfillSpacing { get; init => field = Keys.Check(value); }

    /// <summary>Direction of infill lines in the first layer, counterclockwise from +X.</summary> <value>Degrees.</value>
    public double InfillAngle { get; init => field = Keys.Check(value); } = 45;

    /// <summary>Overlap of infill with the innermost wall, in % of the line width. Solid infill overlaps by two thirds of it.</summary> <value>%.</value>
    public double InfillOverlapPercent { get; init => field = Keys.Check(value); } = 15;

    /// <summary>Maximum deviation of simplified contours.</summary> <value>mm.</value>
    public double Resolution { get; init => field = Keys.Check(value); } = 0.0125;

    /// <summary>Print overlapping models as one solid. Otherwise their overlap is printed twice.</summary>
    public bool MergeOverlappingModels { get; init; } = true;

    /// <summary>Print several models layer by layer, or one by one, lowest first.</summary>
    public PrintSequence PrintSequence { get; init; } = PrintSequence.ByLayer;

    /// <summary>Repair meshes that are not closed: join naked edges, fill holes, turn faces outward.</summary>
    public bool RepairMeshes { get; init; } = true;

    /// <summary>Widest gap to close in contours of broken meshes; 0 = off.</summary> <value>mm.</value>
    public double SliceGapClosing { get; init => field = Keys.Check(value); } = 10;

    /// <summary>Maximum loss of area of a layer of a broken mesh, compared with its neighbors; 100 = no limit.</summary> <value>%.</value>
    public double MaxAreaLossPercent { get; init => field = Keys.Check(value); } = 25;

    /// <summary>Segment length of subdivided curves.</summary> <value>mm.</value>
    public double SubdivisionDistance { get; init => field = Keys.Check(value); } = 1;

    /// <summary>Printing speed.</summary> <value>mm/s.</value>
    public double PrintSpeed { get; init => field = Keys.Check(value); } = 60;

    /// <summary>Speed of outer walls; 0 = printing speed.</summary> <value>mm/s.</value>
    public double OuterWallSpeed { get; init => field = Keys.Check(value); } = 40;

    /// <summary>Speed of sparse infill; 0 = printing speed.</summary> <value>mm/s.</value>
    public double InfillSpeed { get; init => field = Keys.Check(value); }

    /// <summary>Speed of the first layer, at most the printing speed; 0 = as in other layers.</summary> <value>mm/s.</value>
    public double FirstLayerSpeed { get; init => field = Keys.Check(value); } = 25;

    /// <summary>Travel speed.</summary> <value>mm/s.</value>
    public double TravelSpeed { get; init => field = Keys.Check(value); } = 150;

    /// <summary>Z-hop over everything printed, only over extrusions below the travel move, or none.</summary>
    public ZHopType ZHopType { get; init; } = ZHopType.AbovePrint;

    /// <summary>Travel moves up to this length have no Z-hop.</summary> <value>mm.</value>
    public double ZHopMinTravel { get; init => field = Keys.Check(value); } = 2;

    /// <summary>Let travel moves go around printed parts if that is faster than over them.</summary>
    public bool Detour { get; init; }

    /// <summary>Keep travel moves inside the part, without retraction and Z-hop.</summary>
    public bool Comb { get; init; } = true;

    /// <summary>Travel moves up to this length have no retraction.</summary> <value>mm.</value>
    public double RetractionMinTravel { get; init => field = Keys.Check(value); } = 1.5;

    /// <summary>Length of the wipe back along the path during retraction; 0 = off.</summary> <value>mm.</value>
    public double WipeDistance { get; init => field = Keys.Check(value); }

    /// <summary>Deretract while the head descends to the start of a path, instead of afterwards.</summary>
    public bool DeretractDuringDescent { get; init; }

    /// <summary>Length of bead extruded in place before a path starts, for materials that respond late; at most a tenth of the path.</summary>
    /// <value>mm.</value>
    public double StartDistance { get; init => field = Keys.Check(value); }

    /// <summary>Coasting: stop the extruder this far before the end of a path, at most a tenth of its length.</summary> <value>mm.</value>
    public double CoastingDistance { get; init => field = Keys.Check(value); }

    /// <summary>Sort sliced paths within their groups for short travel moves.</summary>
    public bool SortPaths { get; init; } = true;

    /// <summary>Speed in mm/s of paths without their own.</summary>
    public double SpeedOf(Role role, bool firstLayer = false)
    {
        var usual = role == Role.Ironing && IroningSpeed > 0 ? IroningSpeed : PrintSpeed;
        if (firstLayer && FirstLayerSpeed > 0) return Math.Min(FirstLayerSpeed, usual);
        return new RoleValues(OuterWallSpeed, 0, InfillSpeed, SolidInfillSpeed, TopSurfaceSpeed, BridgeSpeed, SupportSpeed).Of(role, 0, usual);
    }

    public override string ToString() => Title;

    /// <summary>Diameter of the nozzle that the settings are for, mm; set by <see cref="PrintSetup"/>.</summary>
    internal double NozzleDiameter { get; init; } = UsualNozzle;

    /// <summary>The settings as given: 0 for sizes that follow from the nozzle.</summary>
    internal PrintSettings AsGiven => this with { NozzleDiameter = 0 };

    // A size is given in mm or as a negative share of the nozzle, or proportional to that.
    private double OfNozzle(double given, double ofUsual)
        => given < 0 && NozzleDiameter > 0 ? -given * NozzleDiameter : given != 0 ? given : ofUsual * (NozzleDiameter * 1000) / (UsualNozzle * 1000);
}
