namespace Caterpillar.Machines;

// Accelerations and jerk, which the file commands if one of them is given.
public sealed partial record PrintSettings
{
    /// <summary>Acceleration of outer walls; 0 = print acceleration of the printer.</summary> <value>mm/s².</value>
    public double OuterWallAcceleration { get; init => field = Keys.Check(value); }

    /// <summary>Acceleration of inner walls and gap fill; 0 = print acceleration of the printer.</summary> <value>mm/s².</value>
    public double InnerWallAcceleration { get; init => field = Keys.Check(value); }

    /// <summary>Acceleration of sparse infill; 0 = print acceleration of the printer.</summary> <value>mm/s².</value>
    public double InfillAcceleration { get; init => field = Keys.Check(value); }

    /// <summary>Acceleration of solid infill and bottom surfaces; 0 = infill acceleration.</summary> <value>mm/s².</value>
    public double SolidInfillAcceleration { get; init => field = Keys.Check(value); }

    /// <summary>Acceleration of top surfaces and ironing; 0 = outer wall acceleration.</summary> <value>mm/s².</value>
    public double TopSurfaceAcceleration { get; init => field = Keys.Check(value); }

    /// <summary>Acceleration of bridges; 0 = print acceleration of the printer.</summary> <value>mm/s².</value>
    public double BridgeAcceleration { get; init => field = Keys.Check(value); }

    /// <summary>Acceleration of supports; 0 = print acceleration of the printer.</summary> <value>mm/s².</value>
    public double SupportAcceleration { get; init => field = Keys.Check(value); }

    /// <summary>Maximum acceleration of extrusions in the first layer; 0 = no limit.</summary> <value>mm/s².</value>
    public double FirstLayerAcceleration { get; init => field = Keys.Check(value); }

    /// <summary>Acceleration of travel moves; 0 = as the firmware has it.</summary> <value>mm/s².</value>
    public double TravelMoveAcceleration { get; init => field = Keys.Check(value); }

    /// <summary>Jerk of outer walls (Klipper: square corner velocity); 0 = jerk of the printer.</summary> <value>mm/s.</value>
    public double OuterWallJerk { get; init => field = Keys.Check(value); }

    /// <summary>Jerk of inner walls and gap fill; 0 = jerk of the printer.</summary> <value>mm/s.</value>
    public double InnerWallJerk { get; init => field = Keys.Check(value); }

    /// <summary>Jerk of infill; 0 = jerk of the printer.</summary> <value>mm/s.</value>
    public double InfillJerk { get; init => field = Keys.Check(value); }

    /// <summary>Jerk of top surfaces and ironing; 0 = outer wall jerk.</summary> <value>mm/s.</value>
    public double TopSurfaceJerk { get; init => field = Keys.Check(value); }

    /// <summary>Maximum jerk of extrusions in the first layer; 0 = no limit.</summary> <value>mm/s.</value>
    public double FirstLayerJerk { get; init => field = Keys.Check(value); }

    /// <summary>Jerk of travel moves; 0 = that of the extrusion before.</summary> <value>mm/s.</value>
    public double TravelMoveJerk { get; init => field = Keys.Check(value); }

    /// <summary>Acceleration in mm/s² of extrusions of a role.</summary>
    /// <param name="role">The role.</param>
    /// <param name="firstLayer">Whether they are in the first layer.</param>
    /// <param name="usual">Print acceleration of the printer, mm/s².</param>
    internal double AccelerationOf(Role role, bool firstLayer, double usual)
        => new RoleValues(OuterWallAcceleration, InnerWallAcceleration, InfillAcceleration, SolidInfillAcceleration, TopSurfaceAcceleration,
            BridgeAcceleration, SupportAcceleration).Of(Like(role), firstLayer ? FirstLayerAcceleration : 0, usual);

    /// <summary>Jerk in mm/s of extrusions of a role.</summary>
    /// <inheritdoc cref="AccelerationOf"/>
    internal double JerkOf(Role role, bool firstLayer, double usual)
        => new RoleValues(OuterWallJerk, InnerWallJerk, InfillJerk, 0, TopSurfaceJerk, 0, 0).Of(Like(role), firstLayer ? FirstLayerJerk : 0, usual);

    private static Role Like(Role role) => role switch
    {
        Role.OverhangWall => Role.OuterWall,
        Role.GapFill => Role.InnerWall,
        Role.Ironing => Role.TopSurface,
        _ => role,
    };
}
