namespace Caterpillar.Flavors;

/// <summary>
/// All G-code flavors. Each has its rules, notes and source in a file of <c>Firmware</c>: on each line a rule, a tab and its value, with <c>-</c> for none.
/// Other rules are as in the flavor that it is <c>Like</c>, or as usual.
/// </summary>
public static class FlavorTable
{
    /// <summary>Neutral rules, as in the viewers of slicers.</summary>
    public static FlavorRules Slicer { get; } = Read("slicer");

    /// <summary>Marlin 2.</summary>
    public static FlavorRules Marlin2 { get; } = Read("marlin2");

    /// <summary>Marlin 1.</summary>
    public static FlavorRules Marlin1 { get; } = Read("marlin1");

    /// <summary>Prusa-Firmware.</summary>
    public static FlavorRules Prusa { get; } = Read("prusa");

    /// <summary>Firmware of Bambu Lab printers.</summary>
    public static FlavorRules Bambu { get; } = Read("bambu");

    /// <summary>Klipper.</summary>
    public static FlavorRules Klipper { get; } = Read("klipper");

    /// <summary>Grbl, for pens and lasers.</summary>
    public static FlavorRules Grbl { get; } = Read("grbl");

    /// <summary>All flavors. The first is neutral. The second is the default if a file does not indicate one.</summary>
    public static IReadOnlyList<FlavorRules> All { get; } =
    [
        Slicer, Marlin2, Marlin1, Prusa, Bambu, Klipper, Read("reprapfirmware"), Read("repetier"), Read("smoothie"), Read("sailfish"), Read("cnc"),
        Read("ultigcode"), Read("bfb"), Grbl,
    ];

    /// <summary>The flavor with this name or common alias, ignoring case, spaces and punctuation; null if unknown.</summary>
    public static FlavorRules? Find(string name)
    {
        if (name is null) throw new ArgumentNullException(nameof(name));
        var plain = new string(name.Where(char.IsLetterOrDigit).ToArray()).ToLowerInvariant();
        return All.FirstOrDefault(d => d.Name == plain || d.OtherNames.Contains(plain));
    }

    private static FlavorRules Read(string name) => new(RuleWords.Of(name));
}
