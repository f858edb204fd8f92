namespace Caterpillar.Machines;

/// <summary>A number for each role of extrusions; 0 = that of a similar role, or the usual.</summary>
internal readonly record struct RoleValues(
    double OuterWall, double InnerWall, double Infill, double SolidInfill, double TopSurface, double Bridge, double Support)
{
    /// <summary>The number for a role: its own or the usual, at most a limit unless that is 0.</summary>
    public double Of(Role role, double limit, double usual)
    {
        var own = role switch
        {
            Role.OuterWall => OuterWall,
            Role.InnerWall => InnerWall,
            Role.TopSurface => TopSurface > 0 ? TopSurface : OuterWall,
            Role.Infill => Infill,
            Role.SolidInfill or Role.BottomSurface => SolidInfill > 0 ? SolidInfill : Infill,
            Role.Bridge => Bridge,
            Role.Support or Role.SupportInterface => Support,
            _ => 0,
        };
        var value = own > 0 ? own : usual;
        return limit > 0 && limit < value ? limit : value;
    }
}
