namespace Caterpillar.Machines;

/// <summary>Advice on an unknown key.</summary>
internal static class UnknownKey
{
    private static readonly Regex AtLayer = new("(^|_)at_(layer|height|z)");

    /// <summary>
    /// An error that names the key that was probably meant, or where the key belongs. Names of other slicers are answered with our key and the value in our
    /// unit.
    /// </summary>
    public static Diagnostic Problem(string kinds, string key, object? value, IEnumerable<string> known, SourceLocation place)
    {
        var names = known.ToArray();
        var plain = key.Replace('-', '_').Replace(' ', '_').ToLowerInvariant();
        // A word that begins several keys names their subject, not one of them without its unit.
        var singular = plain.TrimEnd('s');
        var group = names.Contains(singular) ? [singular] : KeyAdvice.Alike(plain, names, whole: true);
        var other = group.Count > 1 && plain.All(c => c != '_') ? null : KeyAdvice.OtherUnit(plain, names);
        if (SlicerName.Answer(plain, value) is (var ours, _, var sentence))
            return Error(other is null ? "profile.unknown_key" : "profile.wrong_unit", names.Contains(ours) ? sentence : sentence + Belongs(ours));
        if (other is not null)
        {
            var (wrong, right) = (KeyAdvice.UnitOf(plain), KeyAdvice.UnitOf(other));
            var reason = wrong.Length == 0 ? $"{key} does not state its unit." : right.Length == 0 ? $"{key} has no unit."
                : $"{key} is measured in {KeyAdvice.Spoken(right)}, not in {KeyAdvice.Spoken(wrong)}.";
            return Error("profile.wrong_unit", $"{reason} The key is {other}.");
        }
        var message = $"{key} is not a key of {kinds}.";
        if (!names.Contains(key) && ProfileKinds.KindOf(key) is not null) message += Belongs(key);
        else if (AtLayer.IsMatch(plain))
            message += " For G-code at a layer or height, use layer_change_gcode with layer or layer_z_mm, or convert --gcode-at-layer.";
        else if (group.Count > 0) message += $" Did you mean {Words.Either(group)}?";
        else if (SpellingSuggestion.Nearest(plain, names) is { } near) message += $" Did you mean {near}?";
        else if (KeyAdvice.Alike(plain, names, whole: false) is { Count: > 0 } alike) message += $" Did you mean {Words.Either(alike)}?";
        return Error("profile.unknown_key", message);

        Diagnostic Error(string code, string text) => new(Severity.Error, code, text, place);

        static string Belongs(string name) => $" It is a key of {ProfileKinds.KindOf(name)}.";
    }
}
