namespace Caterpillar.Machines;

/// <summary>Keys of one kind of profile, in the order of declaration.</summary>
internal sealed class KeyTable<T> : List<ProfileKey<T>>
    where T : class
{
    /// <summary>A key with its own format.</summary>
    public ProfileKey<T, TValue> Of<TValue>(string name, KeyFormat<TValue> format, Func<T, TValue> get, Func<T, TValue, T> set)
    {
        var key = new ProfileKey<T, TValue>(name, format, get, set);
        Add(key);
        return key;
    }

    public ProfileKey<T, double> Number(string name, double min, double max, Func<T, double> get, Func<T, double, T> set)
        => Of(name, new NumberFormat(min, max), get, set);

    /// <summary>A number that is 0 (off, or the value of another key) or at least <paramref name="least"/>.</summary>
    public ProfileKey<T, double> NumberOrZero(string name, double least, double max, Func<T, double> get, Func<T, double, T> set)
        => Of(name, new NumberFormat(0, max, least), get, set);

    /// <summary>A number, or null for the value of another profile.</summary>
    public ProfileKey<T, double?> Optional(string name, double min, double max, Func<T, double?> get, Func<T, double?, T> set)
        => Of(name, new OptionalNumberFormat(min, max), get, set);

    public ProfileKey<T, int> Integer(string name, int min, int max, Func<T, int> get, Func<T, int, T> set)
        => Of(name, new IntegerFormat(min, max), get, set);

    public ProfileKey<T, bool> Boolean(string name, Func<T, bool> get, Func<T, bool, T> set) => Of(name, new BooleanFormat(), get, set);

    public ProfileKey<T, string> Text(string name, Func<T, string> get, Func<T, string, T> set) => Of(name, new TextFormat(), get, set);

    /// <summary>A value of an enum, from all or some of its members, by name: <c>inside_out</c>.</summary>
    public ProfileKey<T, TValue> Choice<TValue>(string name, Func<T, TValue> get, Func<T, TValue, T> set, params TValue[] some)
        where TValue : struct, Enum
    {
        var all = Enum.GetNames(typeof(TValue)).Select(n => (Words.Snake(n), (TValue)Enum.Parse(typeof(TValue), n)));
        var words = some.Length == 0 ? all.ToArray() : some.Select(s => (Words.Snake(s.ToString()), s)).ToArray();
        return Of(name, new ChoiceFormat<TValue>(words), get, set);
    }

    public ProfileKey<T, Vec3> Vector(string name, double min, double max, Func<T, Vec3> get, Func<T, Vec3, T> set)
        => Of(name, new NumbersFormat<Vec3>(["x", "y", "z"], min, max, n => new Vec3(n[0], n[1], n[2]), v => [v.X, v.Y, v.Z]), get, set);

    public ProfileKey<T, AxisValues> Axes(string name, double min, double max, Func<T, AxisValues> get, Func<T, AxisValues, T> set)
    {
        var format = new NumbersFormat<AxisValues>(
            ["x", "y", "z", "e"], min, max, n => new AxisValues(n[0], n[1], n[2], n[3]), v => [v.X, v.Y, v.Z, v.E]);
        return Of(name, format, get, set);
    }
}
