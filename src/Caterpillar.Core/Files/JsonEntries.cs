namespace Caterpillar.Files;

/// <summary>Entries of JSON objects, each in one call.</summary>
internal static class JsonEntries
{
    /// <summary>A name with a text, a number or a flag; nothing for null.</summary>
    public static void Entry(this JsonTextWriter json, string name, object? value)
    {
        if (value is not null) json.Entry(name, () => json.WriteValue(value));
    }

    /// <summary>A name with what is written next.</summary>
    public static void Entry(this JsonTextWriter json, string name, Action write)
    {
        json.WritePropertyName(name);
        write();
    }

    /// <summary>An object.</summary>
    public static void Object(this JsonTextWriter json, Action write)
    {
        json.WriteStartObject();
        write();
        json.WriteEndObject();
    }

    /// <summary>A list.</summary>
    public static void List<T>(this JsonTextWriter json, IEnumerable<T> items, Action<T> write)
    {
        json.WriteStartArray();
        foreach (var item in items) write(item);
        json.WriteEndArray();
    }
}
