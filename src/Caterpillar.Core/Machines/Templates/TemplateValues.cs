namespace Caterpillar.Machines;

/// <summary>The names of numbers (in the order of the slots of formulas) and texts that a template may contain.</summary>
internal sealed record TemplateNames(string[] Numbers, string[] Texts);

/// <summary>The values of these names. Immutable.</summary>
/// <param name="numbers">The numbers.</param>
/// <param name="texts">The texts.</param>
/// <param name="ofPrint">What is measured of the print, where it is asked for.</param>
internal sealed class TemplateValues(Dictionary<string, double> numbers, Dictionary<string, string> texts, Lazy<Dictionary<string, double>>? ofPrint)
{
    /// <summary>The same with one more number.</summary>
    public TemplateValues With(string name, double value)
        => new(new Dictionary<string, double>(numbers, StringComparer.Ordinal) { [name] = value }, texts, ofPrint);

    /// <summary>The number of this name, or null.</summary>
    public double? Number(string name)
        => numbers.TryGetValue(name, out var value) || (!texts.ContainsKey(name) && ofPrint is { Value: var print } && print.TryGetValue(name, out value))
            ? value : null;

    /// <summary>The text of this name, or null.</summary>
    public string? Text(string name) => texts.TryGetValue(name, out var value) ? value : null;
}
