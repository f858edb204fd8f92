namespace Caterpillar.Flavors;

/// <summary>All G-code flavors. Each has its rules, notes and source in a file of <c>Firmware</c>.</summary>
public static class FlavorTable
{
    /// <summary>Neutral rules, as in the viewers of slicers.</summary>
    public static FlavorRules Slicer { get; } = Flavors.Slicer.Rules;

    /// <summary>Marlin 2.</summary>
    public static FlavorRules Marlin2 { get; } = Flavors.Marlin2.Rules;

    /// <summary>Marlin 1.</summary>
    public static FlavorRules Marlin1 { get; } = Flavors.Marlin1.Rules;

    /// <summary>Prusa-Firmware.</summary>
    public static FlavorRules Prusa { get; } = Flavors.Prusa.Rules;

    /// <summary>Firmware of Bambu Lab printers.</summary>
    public static FlavorRules Bambu { get; } = Flavors.Bambu.Rules;

    /// <summary>Klipper.</summary>
    public static FlavorRules Klipper { get; } = Flavors.Klipper.Rules;

    /// <summary>RepRapFirmware.</summary>
    public static FlavorRules RepRapFirmware { get; } = Flavors.RepRapFirmware.Rules;

    /// <summary>Repetier.</summary>
    public static FlavorRules Repetier { get; } = Flavors.Repetier.Rules;

    /// <summary>Smoothieware.</summary>
    public static FlavorRules Smoothie { get; } = Flavors.Smoothie.Rules;

    /// <summary>Sailfish and MakerWare.</summary>
    public static FlavorRules Sailfish { get; } = Flavors.Sailfish.Rules;

    /// <summary>Mach3 and LinuxCNC: the extruder is the A axis.</summary>
    public static FlavorRules Cnc { get; } = Flavors.Cnc.Rules;

    /// <summary>UltiGCode.</summary>
    public static FlavorRules Ultigcode { get; } = Flavors.Ultigcode.Rules;

    /// <summary>Bits from Bytes, with extruders that are switched on and off.</summary>
    public static FlavorRules Bfb { get; } = Flavors.Bfb.Rules;

    /// <summary>Grbl, for pens and lasers.</summary>
    public static FlavorRules Grbl { get; } = Flavors.Grbl.Rules;

    /// <summary>All flavors. The first is neutral. The second is the default if a file does not indicate one.</summary>
    public static IReadOnlyList<FlavorRules> All { get; } =
        [Slicer, Marlin2, Marlin1, Prusa, Bambu, Klipper, RepRapFirmware, Repetier, Smoothie, Sailfish, Cnc, Ultigcode, Bfb, Grbl];

    /// <summary>The flavor with this name or common alias, ignoring case, spaces and punctuation; null if unknown.</summary>
    public static FlavorRules? Find(string name)
    {
        if (name is null) throw new ArgumentNullException(nameof(name));
        var plain = new string(name.Where(char.IsLetterOrDigit).ToArray()).ToLowerInvariant();
        return All.FirstOrDefault(d => d.Name == plain || d.OtherNames.Contains(plain));
    }
}
