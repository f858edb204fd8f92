namespace Caterpillar.Machines;

// Accelerations and jerk, which the file commands if one of them is given.
public sealed partial record PrintSettings
{
    /// <summary>Acceleration of outer walls; 0 = print acceleration of the printer.</summary> <value>mm/s².</value>
    public double OuterWallAcceleration { get; init => field = RoleMotionKeys.OuterWallAcceleration.Check(value); }

    /// <summary>Acceleration of inner walls and gap fill; 0 = print acceleration of the printer.</summary> <value>mm/s².</value>
    public double InnerWallAcceleration { get; init => field = RoleMotionKeys.InnerWallAcceleration.Check(value); }

    /// <summary>Acceleration of sparse infill; 0 = print acceleration of the printer.</summary> <value>mm/s².</value>
    public double InfillAcceleration { get; init => field = RoleMotionKeys.InfillAcceleration.Check(value); }

    /// <summary>Acceleration of solid infill and bottom surfaces; 0 = infill acceleration.</summary> <value>mm/s².</value>
    public double SolidInfillAcceleration { get; init => field = RoleMotionKeys.SolidInfillAcceleration.Check(value); }

    /// <summary>Acceleration of top surfaces and ironing; 0 = outer wall acceleration.</summary> <value>mm/s².</value>
    public double TopSurfaceAcceleration { get; init => field = RoleMotionKeys.TopSurfaceAcceleration.Check(value); }

    /// <summary>Acceleration of bridges; 0 = print acceleration of the printer.</summary> <value>mm/s².</value>
    public double BridgeAcceleration { get; init => field = RoleMotionKeys.BridgeAcceleration.Check(value); }

    /// <summary>Acceleration of supports; 0 = print acceleration of the printer.</summary> <value>mm/s².</value>
    public double SupportAcceleration { get; init => field = RoleMotionKeys.SupportAcceleration.Check(value); }

    /// <summary>Maximum acceleration of extrusions in the first layer; 0 = no limit.</summary> <value>mm/s².</value>
    public double FirstLayerAcceleration { get; init => field = RoleMotionKeys.FirstLayerAcceleration.Check(value); }

    /// <summary>Acceleration of travel moves; 0 = as the firmware has it.</summary> <value>mm/s².</value>
    public double TravelMoveAcceleration { get; init => field = RoleMotionKeys.TravelMoveAcceleration.Check(value); }

    /// <summary>Jerk of outer walls (Klipper: square corner velocity); 0 = jerk of the printer.</summary> <value>mm/s.</value>
    public double OuterWallJerk { get; init => field = RoleMotionKeys.OuterWallJerk.Check(value); }

    /// <summary>Jerk of inner walls and gap fill; 0 = jerk of the printer.</summary> <value>mm/s.</value>
    public double InnerWallJerk { get; init => field = RoleMotionKeys.InnerWallJerk.Check(value); }

    /// <summary>Jerk of infill; 0 = jerk of the printer.</summary> <value>mm/s.</value>
    public double InfillJerk { get; init => field = RoleMotionKeys.InfillJerk.Check(value); }

    /// <summary>Jerk of top surfaces and ironing; 0 = outer wall jerk.</summary> <value>mm/s.</value>
    public double TopSurfaceJerk { get; init => field = RoleMotionKeys.TopSurfaceJerk.Check(value); }

    /// <summary>Maximum jerk of extrusions in the first layer; 0 = no limit.</summary> <value>mm/s.</value>
    public double FirstLayerJerk { get; init => field = RoleMotionKeys.FirstLayerJerk.Check(value); }

    /// <summary>Jerk of travel moves; 0 = that of the extrusion before.</summary> <value>mm/s.</value>
    public double TravelMoveJerk { get; init => field = RoleMotionKeys.TravelMoveJerk.Check(value); }

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

/// <summary>Keys of print settings: accelerations and jerk.</summary>
internal static class RoleMotionKeys
{
    public static readonly KeyTable<PrintSettings> All = new();

    public static readonly NumberKey OuterWallAcceleration
        = Acceleration("outer_wall_acceleration_mm_s2", s => s.OuterWallAcceleration, (s, v) => s with { OuterWallAcceleration = v });
    public static readonly NumberKey InnerWallAcceleration
        = Acceleration("inner_wall_acceleration_mm_s2", s => s.InnerWallAcceleration, (s, v) => s with { InnerWallAcceleration = v });
    public static readonly NumberKey InfillAcceleration
        = Acceleration("infill_acceleration_mm_s2", s => s.InfillAcceleration, (s, v) => s with { InfillAcceleration = v });
    public static readonly NumberKey SolidInfillAcceleration
        = Acceleration("solid_infill_acceleration_mm_s2", s => s.SolidInfillAcceleration, (s, v) => s with { SolidInfillAcceleration = v });
    public static readonly NumberKey TopSurfaceAcceleration
        = Acceleration("top_surface_acceleration_mm_s2", s => s.TopSurfaceAcceleration, (s, v) => s with { TopSurfaceAcceleration = v });
    public static readonly NumberKey BridgeAcceleration
        = Acceleration("bridge_acceleration_mm_s2", s => s.BridgeAcceleration, (s, v) => s with { BridgeAcceleration = v });
    public static readonly NumberKey SupportAcceleration
        = Acceleration("support_acceleration_mm_s2", s => s.SupportAcceleration, (s, v) => s with { SupportAcceleration = v });
    public static readonly NumberKey FirstLayerAcceleration
        = Acceleration("first_layer_acceleration_mm_s2", s => s.FirstLayerAcceleration, (s, v) => s with { FirstLayerAcceleration = v });
    public static readonly NumberKey TravelMoveAcceleration
        = Acceleration("travel_move_acceleration_mm_s2", s => s.TravelMoveAcceleration, (s, v) => s with { TravelMoveAcceleration = v });
    public static readonly NumberKey OuterWallJerk = Jerk("outer_wall_jerk_mm_s", s => s.OuterWallJerk, (s, v) => s with { OuterWallJerk = v });
    public static readonly NumberKey InnerWallJerk = Jerk("inner_wall_jerk_mm_s", s => s.InnerWallJerk, (s, v) => s with { InnerWallJerk = v });
    public static readonly NumberKey InfillJerk = Jerk("infill_jerk_mm_s", s => s.InfillJerk, (s, v) => s with { InfillJerk = v });
    public static readonly NumberKey TopSurfaceJerk = Jerk("top_surface_jerk_mm_s", s => s.TopSurfaceJerk, (s, v) => s with { TopSurfaceJerk = v });
    public static readonly NumberKey FirstLayerJerk = Jerk("first_layer_jerk_mm_s", s => s.FirstLayerJerk, (s, v) => s with { FirstLayerJerk = v });
    public static readonly NumberKey TravelMoveJerk = Jerk("travel_move_jerk_mm_s", s => s.TravelMoveJerk, (s, v) => s with { TravelMoveJerk = v });

    private static NumberKey Acceleration(string name, Func<PrintSettings, double> get, Func<PrintSettings, double, PrintSettings> set)
        => All.NumberOrZero(name, 1, 1_000_000, get, set);

    private static NumberKey Jerk(string name, Func<PrintSettings, double> get, Func<PrintSettings, double, PrintSettings> set)
        => All.NumberOrZero(name, 0.01, 10_000, get, set);
}
