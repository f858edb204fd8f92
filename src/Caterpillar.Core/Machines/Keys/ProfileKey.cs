namespace Caterpillar.Machines;

/// <summary>Kinds of values of keys.</summary>
internal enum KeyKind : byte
{
    Number,
    Integer,
    Boolean,
    Text,
    Choice,

    /// <summary>A list of numbers of fixed length.</summary>
    Numbers,

    /// <summary>A list of such lists.</summary>
    Rows,

    /// <summary>A list of lines of text.</summary>
    Lines,
}

/// <summary>
/// A key of a profile: its name with the unit, its range and its meaning. Reader, writer, schema, templates and manual all read the keys from
/// <see cref="ProfileKeys"/>.
/// </summary>
internal abstract class ProfileKey
{
    private protected ProfileKey(string name) => Name = name;

    /// <summary>For example <c>layer_height_mm</c>.</summary>
    public string Name { get; }

    /// <summary>One sentence that explains it.</summary>
    public string Summary => KeySentences.Of(Name);

    /// <summary>What kind of value it takes.</summary>
    internal abstract KeyKind Kind { get; }

    /// <summary>The range of the value in words: <c>0.01 to 100</c>, <c>corner or center</c>.</summary>
    public abstract string Range { get; }

    internal abstract KeyFormat Format { get; }

    public override string ToString() => Name;
}

/// <summary>A key of one kind of profile.</summary>
internal abstract class ProfileKey<TProfile>(string name) : ProfileKey(name)
{
    /// <summary>The value as JSON has it: text, double, bool or a list of these.</summary>
    public abstract object Get(TProfile profile);

    /// <summary>Whether two profiles have the same value.</summary>
    public abstract bool IsSame(TProfile one, TProfile other);

    /// <summary>The profile with another value, or null and the problem.</summary>
    public abstract TProfile? Set(TProfile profile, object raw, out string? problem);
}

/// <summary>A key with its typed value.</summary>
internal sealed class ProfileKey<TProfile, TValue>(
    string name, KeyFormat<TValue> format, Func<TProfile, TValue> get, Func<TProfile, TValue, TProfile> set)
    : ProfileKey<TProfile>(name)
    where TProfile : class
{
    internal override KeyKind Kind => format.Kind;

    public override string Range => format.Range;

    internal override KeyFormat Format => format;

    /// <summary>The value itself if it lies in the key's range.</summary>
    /// <exception cref="ArgumentOutOfRangeException">It does not.</exception>
    public TValue Check(TValue value)
    {
        if (value is null) throw new ArgumentNullException(nameof(value), Name);
        return format.Problem(value) is { } problem ? throw new ArgumentOutOfRangeException(nameof(value), value, Name + ": " + problem) : value;
    }

    public override object Get(TProfile profile) => format.Write(get(profile));

    public override bool IsSame(TProfile one, TProfile other) => EqualityComparer<TValue>.Default.Equals(get(one), get(other));

    public override TProfile? Set(TProfile profile, object raw, out string? problem)
    {
        problem = null;
        if (!format.TryRead(raw, out var value)) problem = "needs " + format.Expected + ", not " + KeyFormat.Describe(raw);
        else problem = format.Problem(value!);
        return problem is null ? set(profile, value!) : null;
    }
}
