namespace Caterpillar.GCode;

/// <summary>The position of E in the file, and the modifiers of the extruded amount.</summary>
internal struct ExtrusionState
{
    /// <summary>The position of E, mm (mm³ in volumetric files).</summary>
    public double E;

    // Positions of two extruder axes, in files that use both A and B.
    public double A;
    public double B;

    // E as Marlin 2 would count it, from the first line on where the rules differ.
    public bool HasMarlin2E;
    public double Marlin2E;

    /// <summary>The flow factor (M221) of the current tool.</summary>
    public double Flow;

    /// <summary>True after M101, until M103.</summary>
    public bool IsSwitchedOn;

    public void SetE(double e) => E = Marlin2E = e;
}
