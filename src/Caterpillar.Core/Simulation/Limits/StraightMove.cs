namespace Caterpillar.Simulation;

/// <summary>
/// A straight move: its direction and what limits it, before planning. The direction has X, Y, Z and E for a mm of its length; a move in place has E alone.
/// </summary>
internal struct StraightMove
{
    public double X;
    public double Y;
    public double Z;

    // mm of filament.
    public double E;

    // mm
    public double Length;

    // mm/s
    public double Speed;

    // mm/s²
    public double Acceleration;

    // Deviation from a corner that the square corner velocity stands for, mm.
    public double Deviation;

    // Speed from which the machine may stand still at once, mm/s.
    public double Rest;

    // 1 over the length of the direction with E, for junction deviation.
    public double PerNorm;

    public bool InPlace;

    // What rotary axes allow, mm/s and mm/s²; 0 without them.
    public double MostSpeed;
    public double MostAcceleration;
}
