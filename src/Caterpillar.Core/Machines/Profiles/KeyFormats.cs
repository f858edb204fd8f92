using System;
using System.Collections.Generic;
using System.Linq;
using Caterpillar.Basics;
using Caterpillar.Expressions;

namespace Caterpillar.Machines;

internal sealed class NumberFormat(double min, double max, double leastAboveZero = 0) : KeyFormat<double>
{
    public override KeyKind Kind => KeyKind.Number;

    public override string Expected => "a number";

    public override string Range => RawValues.Range(min, max);

    public override IReadOnlyList<KeyValuePair<string, object>> Schema => [new("type", "number"), new("minimum", min), new("maximum", max)];

    public override object? Parse(string text) => NumberReader.TryParse(text.Trim(), out var value) ? value : null;

    public override bool TryRead(object raw, out double value)
    {
        value = raw is double number ? number : 0;
        return raw is double;
    }

    public override object Write(double value) => value;

    public override string? Problem(double value)
    {
        if (value > 0 && value < leastAboveZero) return "must be 0, or at least " + RawValues.Number(leastAboveZero) + ", not " + Shown(value);
        return value >= min && value <= max ? null : "must be " + Range + (double.IsNaN(value) ? "" : ", not " + Shown(value));
    }

    private static string Shown(double value) => double.IsInfinity(value) ? "infinite" : RawValues.Number(value);
}

internal sealed class IntegerFormat(int min, int max) : KeyFormat<int>
{
    public override KeyKind Kind => KeyKind.Integer;

    public override string Expected => "an integer";

    public override string Range => RawValues.Range(min, max);

    public override IReadOnlyList<KeyValuePair<string, object>> Schema => [new("type", "integer"), new("minimum", (double)min), new("maximum", (double)max)];

    public override object? Parse(string text) => NumberReader.TryParse(text.Trim(), out var value) ? value : null;

    public override bool TryRead(object raw, out int value)
    {
        var whole = raw is double number && number == Math.Floor(number) && Math.Abs(number) <= int.MaxValue;
        value = whole ? (int)(double)raw : 0;
        return whole;
    }

    public override object Write(int value) => (double)value;

    public override string? Problem(int value) => value >= min && value <= max ? null : "must be " + Range + ", not " + NumberFormatter.Format(value);
}

internal sealed class BooleanFormat : KeyFormat<bool>
{
    public override KeyKind Kind => KeyKind.Boolean;

    public override string Expected => "true or false";

    public override string Range => Expected;

    public override IReadOnlyList<KeyValuePair<string, object>> Schema => [new("type", "boolean")];

    public override object? Parse(string text) => text.Trim() switch
    {
        "true" or "yes" or "on" or "1" => true,
        "false" or "no" or "off" or "0" => false,
        _ => null,
    };

    public override bool TryRead(object raw, out bool value)
    {
        value = raw is true;
        return raw is bool;
    }

    public override object Write(bool value) => value;

    public override string? Problem(bool value) => null;
}

internal sealed class TextFormat : KeyFormat<string>
{
    public override KeyKind Kind => KeyKind.Text;

    public override string Expected => "text";

    public override string Range => "text on one line";

    public override IReadOnlyList<KeyValuePair<string, object>> Schema => [new("type", "string"), new("minLength", 1.0)];

    public override object? Parse(string text) => text.Trim();

    public override bool TryRead(object raw, out string? value)
    {
        value = raw as string;
        return value is not null;
    }

    public override object Write(string value) => value;

    public override string? Problem(string value)
        => value.Length == 0 ? "must not be empty" : value.IndexOfAny(['\n', '\r']) >= 0 ? "must be on one line" : null;
}

/// <summary>Lines of a template.</summary>
internal sealed class LinesFormat : KeyFormat<ValueList<string>>
{
    public override KeyKind Kind => KeyKind.Lines;

    public override string Expected => "a list of lines";

    public override string Range => "a list of lines of text";

    public override IReadOnlyList<KeyValuePair<string, object>> Schema
        => [new("type", "array"), new("items", new KeyValuePair<string, object>[] { new("type", "string") })];

    public override object? Parse(string text)
        => text.Length == 0 ? Array.Empty<object>() : text.Split(["\r\n", "\n", "\\n"], StringSplitOptions.None).Cast<object>().ToArray();

    public override bool TryRead(object raw, out ValueList<string>? value)
    {
        value = raw is IReadOnlyList<object> list && list.All(i => i is string) ? new ValueList<string>(list.Cast<string>()) : null;
        return value is not null;
    }

    public override object Write(ValueList<string> value) => value.Cast<object>().ToArray();

    public override string? Problem(ValueList<string> value)
    {
        if (value.Any(l => l is null || l.IndexOfAny(['\n', '\r']) >= 0)) return "has an entry with more than one line";
        var first = Template.Parse(value).Diagnostics.FirstOrDefault();
        return first is null ? null : $"has an error in {first.Source}: {first.Message.TrimEnd('.')}";
    }
}

/// <summary>One of several words.</summary>
internal sealed class ChoiceFormat<TValue>(params (string Word, TValue Value)[] choices) : KeyFormat<TValue>
{
    public override KeyKind Kind => KeyKind.Choice;

    public override string Expected => Range;

    public override string Range => choices.Length == 1
        ? choices[0].Word
        : string.Join(", ", choices.Take(choices.Length - 1).Select(c => c.Word)) + " or " + choices[choices.Length - 1].Word;

    public override string Hint(string word) => SpellingSuggestion.Hint(word, choices.Select(c => c.Word));

    public override IReadOnlyList<KeyValuePair<string, object>> Schema => [new("enum", choices.Select(c => (object)c.Word).ToArray())];

    public override object? Parse(string text) => text.Trim();

    public override bool TryRead(object raw, out TValue? value)
    {
        foreach (var choice in choices)
        {
            if (raw is not string word || word != choice.Word) continue;
            value = choice.Value;
            return true;
        }
        value = default;
        return false;
    }

    public override object Write(TValue value)
    {
        foreach (var choice in choices)
        {
            if (EqualityComparer<TValue>.Default.Equals(choice.Value, value)) return choice.Word;
        }
        throw new ArgumentOutOfRangeException(nameof(value), value, "Not one of the choices.");
    }

    public override string? Problem(TValue value)
        => choices.Any(c => EqualityComparer<TValue>.Default.Equals(c.Value, value)) ? null : "must be " + Range;
}

/// <summary>A value made of a list of numbers of fixed length.</summary>
internal sealed class NumbersFormat<TValue>(string[] parts, double min, double max, Func<double[], TValue> make, Func<TValue, double[]> take)
    : KeyFormat<TValue>
{
    public override KeyKind Kind => KeyKind.Numbers;

    public override string Expected => $"a list of {parts.Length} numbers [{string.Join(", ", parts)}]";

    public override string Range => "[" + string.Join(", ", parts) + "], each " + RawValues.Range(min, max);

    public override IReadOnlyList<KeyValuePair<string, object>> Schema => ListSchema(parts.Length, min, max);

    public override object? Parse(string text) => RawValues.ParseNumbers(text);

    public override bool TryRead(object raw, out TValue? value)
    {
        var numbers = RawValues.Numbers(raw, parts.Length);
        value = numbers is null ? default : make(numbers);
        return numbers is not null;
    }

    public override object Write(TValue value) => RawValues.List(take(value));

    public override string? Problem(TValue value)
        => Array.TrueForAll(take(value), n => n >= min && n <= max) ? null : "must have numbers of " + RawValues.Range(min, max);

    internal static IReadOnlyList<KeyValuePair<string, object>> ListSchema(int count, double min, double max) =>
    [
        new("type", "array"),
        new("items", new KeyValuePair<string, object>[] { new("type", "number"), new("minimum", min), new("maximum", max) }),
        new("minItems", (double)count),
        new("maxItems", (double)count),
    ];
}

/// <summary>A list of rows of numbers.</summary>
internal sealed class RowsFormat<TItem>(
    string[] parts, int minCount, int maxCount, double min, double max, Func<double[], TItem?> make, Func<TItem, double[]> take, Func<ValueList<TItem>,
        string?>? check = null)
    : KeyFormat<ValueList<TItem>>
    where TItem : struct
{
    public override KeyKind Kind => KeyKind.Rows;

    public override string Expected => $"a list of lists [{string.Join(", ", parts)}]";

    public override string Range => $"{NumberFormatter.Format(minCount)} to {NumberFormatter.Format(maxCount)} lists [{string.Join(", ", parts)}]";

    public override IReadOnlyList<KeyValuePair<string, object>> Schema =>
    [
        new("type", "array"),
        new("items", NumbersFormat<double>.ListSchema(parts.Length, min, max)),
        new("minItems", (double)minCount),
        new("maxItems", (double)maxCount),
    ];

    public override object? Parse(string text) => RawValues.ParseRows(text);

    public override bool TryRead(object raw, out ValueList<TItem>? value)
    {
        value = null;
        if (raw is not IReadOnlyList<object> list) return false;
        var items = new TItem[list.Count];
        for (var i = 0; i < items.Length; i++)
        {
            if (RawValues.Numbers(list[i], parts.Length) is not { } numbers || make(numbers) is not { } item) return false;
            items[i] = item;
        }
        value = new ValueList<TItem>(items);
        return true;
    }

    public override object Write(ValueList<TItem> value) => value.Select(i => RawValues.List(take(i))).ToArray();

    public override string? Problem(ValueList<TItem> value)
    {
        if (value.Count < minCount || value.Count > maxCount) return "must have " + Range;
        foreach (var item in value)
        {
            if (!Array.TrueForAll(take(item), n => n >= min && n <= max)) return "must have numbers of " + RawValues.Range(min, max);
        }
        return check?.Invoke(value);
    }
}
