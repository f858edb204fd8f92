namespace Caterpillar.Machines;

/// <summary>A preset of another slicer.</summary>
/// <param name="Kind"><c>printer</c>, <c>print</c> or <c>filament</c>; empty for all three in one.</param>
/// <param name="Name">Its name.</param>
/// <param name="Values">Its values as text, with those that it inherits. Lists are separated by commas.</param>
/// <param name="IsBase">True if it is only there to be inherited.</param>
internal sealed record SlicerPreset(string Kind, string Name, IReadOnlyDictionary<string, string> Values, bool IsBase)
{
    /// <summary>The first item of a value; empty if it is missing.</summary>
    public string First(string key) => SlicerName.FirstOf(Values, key) ?? "";

    /// <summary>True for a name of a slicer whose presets can be read.</summary>
    public static bool IsKnown(string key) => SlicerName.Of("PrusaSlicer", key).Any() || SlicerName.Of("OrcaSlicer", key).Any();

    /// <summary>The slicer whose names these are.</summary>
    public static string SlicerOf(IReadOnlyDictionary<string, string> values)
        => values.Keys.Count(k => SlicerName.Of("OrcaSlicer", k).Any()) > values.Keys.Count(k => SlicerName.Of("PrusaSlicer", k).Any())
            ? "OrcaSlicer" : "PrusaSlicer";
}
