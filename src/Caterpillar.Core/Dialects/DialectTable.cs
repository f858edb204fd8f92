namespace Caterpillar.Dialects;

/// <summary>The dialects of G-code that are known; the rules, the notes and the source of each are one file of <c>Firmware</c>.</summary>
public static class DialectTable
{
    /// <summary>The neutral reading: the rules of slicers' own viewers.</summary>
    public static DialectRules Slicer { get; } = Dialects.Slicer.Rules;

    /// <summary>Marlin 2.</summary>
    public static DialectRules Marlin2 { get; } = Dialects.Marlin2.Rules;

    /// <summary>Marlin 1.</summary>
    public static DialectRules Marlin1 { get; } = Dialects.Marlin1.Rules;

    /// <summary>Prusa-Firmware.</summary>
    public static DialectRules Prusa { get; } = Dialects.Prusa.Rules;

    /// <summary>Firmware of Bambu Lab's printers.</summary>
    public static DialectRules Bambu { get; } = Dialects.Bambu.Rules;

    /// <summary>Klipper.</summary>
    public static DialectRules Klipper { get; } = Dialects.Klipper.Rules;

    /// <summary>RepRapFirmware.</summary>
    public static DialectRules RepRapFirmware { get; } = Dialects.RepRapFirmware.Rules;

    /// <summary>Repetier.</summary>
    public static DialectRules Repetier { get; } = Dialects.Repetier.Rules;

    /// <summary>Smoothieware.</summary>
    public static DialectRules Smoothie { get; } = Dialects.Smoothie.Rules;

    /// <summary>Sailfish and MakerWare.</summary>
    public static DialectRules Sailfish { get; } = Dialects.Sailfish.Rules;

    /// <summary>Mach3 and LinuxCNC: the extruder is the A axis.</summary>
    public static DialectRules Cnc { get; } = Dialects.Cnc.Rules;

    /// <summary>UltiGCode.</summary>
    public static DialectRules Ultigcode { get; } = Dialects.Ultigcode.Rules;

    /// <summary>Bits from Bytes, whose extruders are switched on and off.</summary>
    public static DialectRules Bfb { get; } = Dialects.Bfb.Rules;

    /// <summary>Grbl, for pens and lasers.</summary>
    public static DialectRules Grbl { get; } = Dialects.Grbl.Rules;

    /// <summary>All of them; the first is the neutral one, the second is taken where a file says nothing.</summary>
    public static IReadOnlyList<DialectRules> All { get; } =
        [Slicer, Marlin2, Marlin1, Prusa, Bambu, Klipper, RepRapFirmware, Repetier, Smoothie, Sailfish, Cnc, Ultigcode, Bfb, Grbl];

    /// <summary>The dialect with this name (case, spaces and signs do not matter; common other names are known), or null.</summary>
    public static DialectRules? Find(string name)
    {
        if (name is null) throw new ArgumentNullException(nameof(name));
        var plain = new string(name.Where(char.IsLetterOrDigit).ToArray()).ToLowerInvariant();
        return All.FirstOrDefault(d => d.Name == plain || d.OtherNames.Contains(plain));
    }
}
