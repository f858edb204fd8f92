namespace Caterpillar.Flavors;

/// <summary>Waiting, speed factors and the fan.</summary>
public sealed partial class FlavorRules
{
    /// <summary>Commands that wait for a time. The writer uses the first.</summary>
    internal IReadOnlyList<string> Dwells { get; } = words.List(nameof(Dwells), "G4");

    /// <summary>Seconds per unit of P in G4.</summary>
    internal double DwellP { get; } = words.Number(nameof(DwellP), 0.001);

    /// <summary>Seconds per unit of S in G4, which replaces P; 0 = S is ignored.</summary>
    internal double DwellS { get; } = words.Number(nameof(DwellS), 1);

    /// <summary>P and S of G4 add up.</summary>
    internal bool DwellSums { get; } = words.Is(nameof(DwellSums));

    /// <summary>M220 S scales the speed, in percent.</summary>
    internal bool SpeedFactor { get; } = words.Is(nameof(SpeedFactor));

    /// <summary>What B and R of M220 do.</summary>
    internal SpeedMemoryRule SpeedMemory { get; } = words.One<SpeedMemoryRule>(nameof(SpeedMemory));

    /// <summary>M220 and M221 without S mean 100 %.</summary>
    internal bool FactorsReset { get; } = words.Is(nameof(FactorsReset));

    /// <summary>How objects are marked, so that one can be left out while printing.</summary>
    internal ObjectMarking ObjectMarks { get; } = words.One<ObjectMarking>(nameof(ObjectMarks));

    /// <summary>M104, M109, M140 and M190 without S switch the heater off. Otherwise they do nothing.</summary>
    internal bool NoTargetIsOff { get; } = words.Is(nameof(NoTargetIsOff));

    /// <summary>Meaning of the number of M106.</summary>
    internal FanScale Fan { get; } = words.One(nameof(Fan), FanScale.Byte);

    /// <summary>The letter of the fan speed in M106.</summary>
    internal char FanLetter { get; } = words.Text(nameof(FanLetter), "S")[0];

    /// <summary>P of M106 and M107 is the number of a fan. Otherwise they are for the part cooling fan, whatever P is.</summary>
    internal bool FanNumbers { get; } = words.Is(nameof(FanNumbers), true);

    /// <summary>M126 and M127 switch the part cooling fan.</summary>
    internal bool ValveIsFan { get; } = words.Is(nameof(ValveIsFan));

    /// <summary>Seconds that a dwell with these words takes; null for a missing word.</summary>
    internal double DwellSeconds(double? p, double? s)
    {
        var ofP = (p ?? 0) * DwellP;
        if (s is null || DwellS == 0) return ofP;
        return DwellSums ? ofP + s.Value * DwellS : s.Value * DwellS;
    }
}

/// <summary>Order of B and R of M220: B saves the speed factor, R restores it.</summary>
internal enum SpeedMemoryRule
{
    /// <summary>Nothing.</summary>
    None,

    /// <summary>B, then S, then R.</summary>
    RestoresLast,

    /// <summary>R, then B (of the factor before the line), then S.</summary>
    RestoresFirst,
}

/// <summary>Meaning of the number of M106 S.</summary>
internal enum FanScale
{
    /// <summary>0 to 255.</summary>
    Byte,

    /// <summary>0 to 1; numbers above 1 are 0 to 255.</summary>
    FractionOrByte,

    /// <summary>0 = off, other numbers = on.</summary>
    Switch,

    /// <summary>M106 and M107 are unknown.</summary>
    None,
}

/// <summary>Commands that mark objects.</summary>
internal enum ObjectMarking
{
    /// <summary>None.</summary>
    None,

    /// <summary>M486 T and S.</summary>
    Numbers,

    /// <summary>M486 T and S, with names (A).</summary>
    NumbersWithNames,

    /// <summary>EXCLUDE_OBJECT_DEFINE, _START and _END.</summary>
    Names,
}
