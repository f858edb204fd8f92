namespace Caterpillar.GCode;

/// <summary>Modal state: a command changes it for all following lines.</summary>
internal struct Modes
{
    /// <summary>The last motion command: 0 to 3.</summary>
    public int Motion;

    public ArcPlane Plane;
    public bool Relative;
    public bool Inches;
    public bool AbsoluteCenters;
    public bool Volumetric;

    // M83, and whether the last of G90, G91, M82 and M83 was a relative one.
    public bool M83;
    public bool LastRelative;

    /// <summary>True if E words are relative by the rule of the firmware.</summary>
    public bool RelativeE;

    /// <summary>True if firmwares disagree whether E words are relative.</summary>
    public bool IsRelativeEDisputed;

    /// <summary>True if the fast path applies: absolute, mm, and no doubt about the mode of E.</summary>
    public bool IsPlain;

    /// <summary>mm per unit of X, Y and Z.</summary>
    public readonly double Unit => Inches ? Units.MmPerInch : 1;

    /// <summary>mm (or mm³) per unit of E.</summary>
    public readonly double UnitOfE(FlavorRules rules) => !Inches ? 1 : rules.InchesOfE switch
    {
        InchesOfERule.Unchanged => 1,
        InchesOfERule.InchesOrCubic when Volumetric => Units.MmPerInch * Units.MmPerInch * Units.MmPerInch,
        _ => Units.MmPerInch,
    };

    /// <summary>Updates after a change of mode whether E is relative.</summary>
    public void ResolveE(RelativeERule rule)
    {
        var either = Relative || M83;
        RelativeE = rule switch
        {
            RelativeERule.EitherG91OrM83 => either,
            RelativeERule.LastWins => LastRelative,
            RelativeERule.OnlyM82M83 => M83,
            _ => Relative,
        };
        IsRelativeEDisputed = either != LastRelative || either != M83;
    }

    public readonly bool ReadsLike(in Modes other)
        => Motion == other.Motion && Plane == other.Plane && Relative == other.Relative && Inches == other.Inches && M83 == other.M83
            && LastRelative == other.LastRelative && AbsoluteCenters == other.AbsoluteCenters && Volumetric == other.Volumetric;
}
