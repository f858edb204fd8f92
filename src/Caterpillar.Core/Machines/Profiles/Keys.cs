using System;
using Caterpillar.Geometry;

namespace Caterpillar.Machines;

/// <summary>Shorthands to declare the keys of one kind of profile.</summary>
internal static class Keys<T>
    where T : class
{
    public static ProfileKey<T, double> Number(string name, double min, double max, Func<T, double> get, Func<T, double, T> set, string summary)
        => new(name, new NumberFormat(min, max), get, set, summary);

    /// <summary>A number for which 0 means something else (off, or the value of another key), and very small ones mean nothing.</summary>
    public static ProfileKey<T, double> NumberOrZero(
        string name, double least, double max, Func<T, double> get, Func<T, double, T> set, string summary)
        => new(name, new NumberFormat(0, max, least), get, set, summary);

    public static ProfileKey<T, int> Integer(string name, int min, int max, Func<T, int> get, Func<T, int, T> set, string summary)
        => new(name, new IntegerFormat(min, max), get, set, summary);

    public static ProfileKey<T, bool> Boolean(string name, Func<T, bool> get, Func<T, bool, T> set, string summary)
        => new(name, new BooleanFormat(), get, set, summary);

    public static ProfileKey<T, string> Text(string name, Func<T, string> get, Func<T, string, T> set, string summary)
        => new(name, new TextFormat(), get, set, summary);

    public static ProfileKey<T, ValueList<string>> Lines(string name, Func<T, ValueList<string>> get, Func<T, ValueList<string>, T> set, string summary)
        => new(name, new LinesFormat(), get, set, summary);

    public static ProfileKey<T, TValue> Choice<TValue>(
        string name, Func<T, TValue> get, Func<T, TValue, T> set, string summary, params (string Word, TValue Value)[] choices)
        => new(name, new ChoiceFormat<TValue>(choices), get, set, summary);

    public static ProfileKey<T, Vec3> Vector(string name, double min, double max, Func<T, Vec3> get, Func<T, Vec3, T> set, string summary)
        => new(name, new NumbersFormat<Vec3>(["x", "y", "z"], min, max, n => new Vec3(n[0], n[1], n[2]), v => [v.X, v.Y, v.Z]), get, set, summary);

    public static ProfileKey<T, AxisValues> Axes(string name, double min, double max, Func<T, AxisValues> get, Func<T, AxisValues, T> set, string summary)
        => new(name, new NumbersFormat<AxisValues>(["x", "y", "z", "e"], min, max, n => new AxisValues(n[0], n[1], n[2], n[3]), v => [v.X, v.Y, v.Z, v.E]), get,
            set, summary);
}
