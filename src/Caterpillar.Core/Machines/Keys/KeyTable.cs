using System.Reflection;

namespace Caterpillar.Machines;

/// <summary>Keys of one kind of profile, from a table with a row for each: property, key, and the range of its numbers or the words of its choice.</summary>
internal static class KeyTable
{
    /// <summary>The keys of a table.</summary>
    /// <param name="table">Name of the file.</param>
    /// <param name="properties">The properties of the profile. Their types decide on the formats.</param>
    /// <param name="own">Formats of properties that a row cannot describe.</param>
    /// <param name="copy">Copies a profile.</param>
    public static IReadOnlyList<ProfileKey<T>> Read<T>(
        string table, PropertyInfo[] properties, IReadOnlyDictionary<string, KeyFormat> own, Func<T, T> copy)
        where T : class
        => [.. EmbeddedText.Rows("names/" + table).Select(row =>
        {
            var property = Array.Find(properties, p => p.Name == row[0]) ?? throw new InvalidOperationException($"{table}: no property {row[0]}.");
            return new ProfileKey<T>(row[1], own.TryGetValue(row[0], out var format) ? format : Format(property.PropertyType, row), property, copy);
        })];

    private static KeyFormat Format(Type type, string[] row)
    {
        if (type == typeof(bool)) return new BooleanFormat();
        if (type == typeof(string)) return new TextFormat();
        if (type.IsEnum) return Choice(type, [.. row.Skip(2)]);
        // A size in mm or in % of the nozzle diameter, or 0 for that of another key.
        if (row[2] == "nozzle") return new NozzleSizeFormat();
        var (min, max) = (Number(row[2]), Number(row[3]));
        // Some numbers are 0 (off, or the value of another key) or at least a number.
        if (type == typeof(double)) return new NumberFormat(min, max, row.Length > 4 ? Number(row[4]) : 0);
        if (type == typeof(double?)) return new OptionalNumberFormat(min, max);
        if (type == typeof(int)) return new IntegerFormat((int)min, (int)max);
        if (type == typeof(Vec3)) return new NumbersFormat<Vec3>(["x", "y", "z"], min, max, n => new Vec3(n[0], n[1], n[2]), v => [v.X, v.Y, v.Z]);
        return new NumbersFormat<AxisValues>(["x", "y", "z", "e"], min, max, n => new AxisValues(n[0], n[1], n[2], n[3]), v => [v.X, v.Y, v.Z, v.E]);
    }

    // A value of an enum, from all or some of its members, by name: inside_out.
    private static ChoiceFormat Choice(Type type, string[] some)
    {
        var all = Enum.GetNames(type).Select(n => (Word: Words.Snake(n), Value: Enum.Parse(type, n))).ToArray();
        return new ChoiceFormat(some.Length == 0 ? all : Array.ConvertAll(some, word => all.First(c => c.Word == word)));
    }

    private static double Number(string text) => NumberReader.TryParse(text, out var value) ? value : throw new FormatException(text);
}
