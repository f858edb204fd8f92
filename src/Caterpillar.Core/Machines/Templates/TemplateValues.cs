namespace Caterpillar.Machines;

/// <summary>The names of numbers (in the order of the slots of formulas) and texts that a template may contain.</summary>
internal sealed record TemplateNames(string[] Numbers, string[] Texts);

/// <summary>The values of these names. Immutable.</summary>
internal sealed class TemplateValues(Dictionary<string, double> numbers, Dictionary<string, string> texts, Lazy<Dictionary<string, double>>? ofPrint)
{
    private readonly Dictionary<string, double> _numbers = numbers;
    private readonly Dictionary<string, string> _texts = texts;

    // What is measured of the print, where it is asked for.
    private readonly Lazy<Dictionary<string, double>>? _ofPrint = ofPrint;

    /// <summary>The same with one more number.</summary>
    public TemplateValues With(string name, double value)
        => new(new Dictionary<string, double>(_numbers, StringComparer.Ordinal) { [name] = value }, _texts, _ofPrint);

    /// <summary>The number of this name, or null.</summary>
    public double? Number(string name)
        => _numbers.TryGetValue(name, out var value) || (!_texts.ContainsKey(name) && _ofPrint is { Value: var print } && print.TryGetValue(name, out value))
            ? value : null;

    /// <summary>The text of this name, or null.</summary>
    public string? Text(string name) => _texts.TryGetValue(name, out var value) ? value : null;
}
