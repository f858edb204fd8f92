using System.Reflection;

namespace Caterpillar.Machines;

/// <summary>Types of values of keys.</summary>
public enum KeyKind : byte
{
    /// <summary>A number.</summary>
    Number,

    /// <summary>A whole number.</summary>
    Integer,

    /// <summary>True or false.</summary>
    Boolean,

    /// <summary>Text on one line.</summary>
    Text,

    /// <summary>One of several words.</summary>
    Choice,

    /// <summary>A list of numbers of fixed length.</summary>
    Numbers,

    /// <summary>A list of such lists.</summary>
    Rows,

    /// <summary>A list of lines of text.</summary>
    Lines,
}

/// <summary>
/// A key of a profile: its name with the unit, its range and its description. Reader, writer, schema, templates and manual all use the keys of
/// <see cref="ProfileKeys"/>.
/// </summary>
public abstract class ProfileKey
{
    private protected ProfileKey(string name) => Name = name;

    /// <summary>For example <c>layer_height_mm</c>.</summary>
    public string Name { get; }

    /// <summary>Description of the key.</summary>
    public string Summary => KeySentences.Of(Name);

    /// <summary>The unit as people write it: <c>mm/s²</c>. Empty for ratios, counts and words.</summary>
    public string Unit => KeyAdvice.Spoken(KeyAdvice.UnitOf(Name));

    /// <summary>Type of the value.</summary>
    public abstract KeyKind Kind { get; }

    /// <summary>The range of the value in words: <c>0.01 to 100</c>, <c>corner or center</c>.</summary>
    public abstract string Range { get; }

    /// <summary>The words of a choice.</summary>
    public IReadOnlyList<string> Choices => Format.Choices;

    /// <summary>Whether a share of the nozzle diameter such as <c>110%</c> is a value, too.</summary>
    public bool TakesPercent => Format is NozzleSizeFormat;

    internal abstract KeyFormat Format { get; }

    /// <summary>What is wrong with a raw value, after the name of the key; null if nothing.</summary>
    internal abstract string? Problem(object raw);

    /// <summary>The name.</summary>
    public override string ToString() => Name;
}

/// <summary>A key of one kind of profile, and the property of its value.</summary>
internal sealed class ProfileKey<TProfile>(string name, KeyFormat format, PropertyInfo property, Func<TProfile, TProfile> copy) : ProfileKey(name)
    where TProfile : class
{
    /// <summary>Name of the property.</summary>
    public string Property => property.Name;

    public override KeyKind Kind => format.Kind;

    public override string Range => format.Range;

    internal override KeyFormat Format => format;

    /// <summary>The value itself if it is in the range of the key.</summary>
    /// <exception cref="ArgumentOutOfRangeException">It is not.</exception>
    public TValue Check<TValue>(TValue value)
    {
        if (value is null && !typeof(TValue).IsValueType) throw new ArgumentNullException(nameof(value), Name);
        return format.ProblemOf(value) is { } problem ? throw new ArgumentOutOfRangeException(nameof(value), value, Name + ": " + problem) : value;
    }

    /// <summary>The value as in JSON: text, double, bool or a list of these.</summary>
    public object Get(TProfile profile) => format.Written(property.GetValue(profile));

    /// <summary>Whether two profiles have the same value.</summary>
    public bool IsSame(TProfile one, TProfile other) => Equals(property.GetValue(one), property.GetValue(other));

    internal override string? Problem(object raw)
        => format.Fits(raw) ? format.ProblemOf(format.ValueOf(raw)) : "needs " + format.Expected + ", not " + KeyFormat.Describe(raw);

    /// <summary>The profile with another value, or null and the problem.</summary>
    public TProfile? Set(TProfile profile, object raw, out string? problem)
    {
        problem = Problem(raw);
        if (problem is not null) return null;
        var changed = copy(profile);
        property.SetValue(changed, format.ValueOf(raw));
        return changed;
    }
}
