namespace Caterpillar.Machines;

/// <summary>Position of the origin (X 0, Y 0) on the bed.</summary>
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

/// <summary>Relative or absolute E.</summary>
public enum ExtrusionMode : byte
{
    /// <summary>Relative E (M83).</summary>
    Relative,

    /// <summary>Absolute E (M82).</summary>
    Absolute,
}

/// <summary>What X, Y and Z say on a printer with rotary axes.</summary>
public enum RotaryPositions : byte
{
    /// <summary>The place of the nozzle tip on the part, for controllers with tool center point control.</summary>
    Tip,

    /// <summary>The positions of the slides.</summary>
    Machine,

    /// <summary>The positions of the slides, of which Y does not exist: an axis of the work about z brings every place under the nozzle.</summary>
    Polar,
}

/// <summary>Unit of E.</summary>
public enum ExtrusionUnit : byte
{
    /// <summary>mm of filament, or of plunger travel.</summary>
    Mm,

    /// <summary>mm³ of material (volumetric firmware).</summary>
    Mm3,

    /// <summary>No E: a pen, a brush, a hot tool.</summary>
    None,
}

/// <summary>How the firmware limits speed in corners.</summary>
public enum Cornering : byte
{
    /// <summary>By the instantaneous change of speed of each axis (classic jerk of Marlin, M566 of RepRapFirmware).</summary>
    Jerk,

    /// <summary>By the deviation from the corner of an arc of constant acceleration (Marlin 2, Grbl).</summary>
    JunctionDeviation,

    /// <summary>By the speed through a corner of 90° (Klipper).</summary>
    SquareCornerVelocity,
}

/// <summary>Height of Z-hops.</summary>
public enum ZHopType : byte
{
    /// <summary>Above everything printed so far.</summary>
    AbovePrint,

    /// <summary>Above the extrusions below the travel move.</summary>
    AbovePath,

    /// <summary>No Z-hop: travel moves are straight lines.</summary>
    None,
}

/// <summary>One number per axis.</summary>
public readonly record struct AxisValues(double X, double Y, double Z, double E);

/// <summary>
/// A point of the outline of a print head: no part within <paramref name="Radius"/> mm of its axis is lower than <paramref name="Height"/> mm above the tip.
/// </summary>
public readonly record struct HeadPoint(double Radius, double Height);

/// <summary>Order of several models.</summary>
public enum PrintSequence
{
    /// <summary>Layer by layer, all models together.</summary>
    ByLayer,

    /// <summary>One by one, lowest first.</summary>
    ByObject,
}
