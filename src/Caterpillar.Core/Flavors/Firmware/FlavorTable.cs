namespace Caterpillar.Flavors;

/// <summary>All G-code flavors. Each has its rules, notes and source in a file of <c>Firmware</c>.</summary>
public static partial class FlavorTable
{
    private static readonly Lazy<IReadOnlyList<FlavorRules>> Flavors = new(List);

    /// <summary>All flavors. The first is neutral. The second is the default if a file does not indicate one.</summary>
    public static IReadOnlyList<FlavorRules> All => Flavors.Value;

    /// <summary>The flavor with this name or common alias, ignoring case, spaces and punctuation; null if unknown.</summary>
    public static FlavorRules? Find(string name)
    {
        if (name is null) throw new ArgumentNullException(nameof(name));
        var plain = new string(name.Where(char.IsLetterOrDigit).ToArray()).ToLowerInvariant();
        return All.FirstOrDefault(d => d.Name == plain || d.OtherNames.Contains(plain));
    }

    private static IReadOnlyList<FlavorRules> List()
        => [Slicer, Marlin2, Marlin1, Prusa, Bambu, Klipper, RepRapFirmware, Repetier, Smoothie, Sailfish, Cnc, Ultigcode, Bfb, Grbl];
}
