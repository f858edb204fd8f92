namespace Caterpillar.Machines;

/// <summary>Where a printer has its origin (X 0, Y 0).</summary>
public enum BedOrigin : byte
{
    /// <summary>At the front left corner of the bed.</summary>
    Corner,

    /// <summary>In the middle of the bed.</summary>
    Center,
}

/// <summary>Outline of the bed.</summary>
public enum BedShape : byte
{
    Rectangle,

    /// <summary>A circle, or an ellipse if the build volume is not square.</summary>
    Round,
}

/// <summary>How the writer states E.</summary>
public enum ExtrusionMode : byte
{
    /// <summary>Increments (M83).</summary>
    Relative,

    /// <summary>Sums (M82).</summary>
    Absolute,
}

/// <summary>Unit of E.</summary>
public enum ExtrusionUnit : byte
{
    /// <summary>One mm of filament, or of the travel of a plunger.</summary>
    Mm,

    /// <summary>One mm³ of material (volumetric firmware).</summary>
    Mm3,

    /// <summary>There is no E: a pen, a brush, a bare hot tool.</summary>
    None,
}

/// <summary>How the firmware limits the speed in corners.</summary>
public enum Cornering : byte
{
    /// <summary>By the sudden change of the speed of each axis (Marlin's classic jerk, RepRapFirmware's M566).</summary>
    Jerk,

    /// <summary>By the deviation from the corner that an arc of constant acceleration would need (Marlin 2, Grbl).</summary>
    JunctionDeviation,

    /// <summary>By the speed through a corner of 90° (Klipper).</summary>
    SquareCornerVelocity,
}

/// <summary>How high the head lifts for travels.</summary>
public enum ZHopType : byte
{
    /// <summary>Above the highest point printed so far.</summary>
    AbovePrint,

    /// <summary>Above what lies under the path of the travel.</summary>
    AbovePath,

    /// <summary>No lift: travels are straight lines.</summary>
    None,
}

/// <summary>One number per axis.</summary>
public readonly record struct AxisValues(double X, double Y, double Z, double E);

/// <summary>
/// A point of the outline of a head: no part of the head within <paramref name="Radius"/> mm of its axis is lower than <paramref name="Height"/> mm above the
/// tip.
/// </summary>
public readonly record struct HeadPoint(double Radius, double Height);

/// <summary>In which order several models are printed.</summary>
public enum PrintSequence
{
    /// <summary>A layer of each, then the next.</summary>
    ByLayer,

    /// <summary>One after the other, the lowest first.</summary>
    ByObject,
}
