namespace Caterpillar.Toolpaths;

/// <summary>Compressed bytes that other files hold. Records are JSON, so that they may get more properties; numbers in masses are binary.</summary>
internal static class Packed
{
    private const byte Version = 1;
    private static readonly JsonSerializerSettings Plain = new()
    {
        NullValueHandling = NullValueHandling.Ignore, Culture = System.Globalization.CultureInfo.InvariantCulture,
    };

    public static byte[] Pack(Action<BinaryWriter> write)
    {
        using var memory = new MemoryStream();
        memory.WriteByte(Version);
        using (var writer = new BinaryWriter(new DeflateStream(memory, CompressionLevel.Optimal, leaveOpen: true))) write(writer);
        return memory.ToArray();
    }

    /// <summary>What was packed. Null for bytes of another version and for bytes that are damaged.</summary>
    public static T? Unpack<T>(byte[] bytes, Func<BinaryReader, T> read)
        where T : class
    {
        if (bytes is null || bytes.Length == 0 || bytes[0] != Version) return null;
        try
        {
            using var reader = new BinaryReader(new DeflateStream(new MemoryStream(bytes, 1, bytes.Length - 1), CompressionMode.Decompress));
            return read(reader);
        }
        catch (Exception e) when (e is IOException or InvalidDataException or JsonException or ArgumentException or FormatException or OverflowException
            or IndexOutOfRangeException)
        {
            return null;
        }
    }

    public static void WriteRecord<T>(this BinaryWriter writer, T? value)
        where T : class
        => writer.Write(value is null ? "" : JsonConvert.SerializeObject(value, Plain));

    public static T? ReadRecord<T>(this BinaryReader reader)
        where T : class
        => reader.ReadString() is { Length: > 0 } json ? JsonConvert.DeserializeObject<T>(json, Plain) : null;

    public static void WriteEvent(this BinaryWriter writer, PrinterEvent what)
    {
        writer.Write(what.GetType().Name);
        writer.Write(JsonConvert.SerializeObject(what, Plain));
    }

    public static PrinterEvent ReadEvent(this BinaryReader reader)
    {
        var type = typeof(PrinterEvent).Assembly.GetType(typeof(PrinterEvent).Namespace + "." + reader.ReadString());
        var json = reader.ReadString();
        return type is not null && type.IsSubclassOf(typeof(PrinterEvent)) && JsonConvert.DeserializeObject(json, type, Plain) is PrinterEvent what
            ? what : throw new InvalidDataException();
    }

    public static void WriteList<T>(this BinaryWriter writer, IReadOnlyList<T> items, Action<T> write)
    {
        writer.Write(items.Count);
        foreach (var item in items) write(item);
    }

    // Damaged counts must not take all memory: the list grows with what is there.
    public static List<T> ReadList<T>(this BinaryReader reader, Func<T> read)
    {
        var items = new List<T>();
        for (var left = reader.ReadInt32(); left > 0; left--) items.Add(read());
        return items;
    }

    public static void Write(this BinaryWriter writer, Vec3 point)
    {
        writer.Write(point.X);
        writer.Write(point.Y);
        writer.Write(point.Z);
    }

    public static Vec3 ReadPoint(this BinaryReader reader) => new(reader.ReadDouble(), reader.ReadDouble(), reader.ReadDouble());

    public static void Write(this BinaryWriter writer, Arc arc)
    {
        writer.Write(arc.Center);
        writer.Write(arc.Sweep);
        writer.Write((byte)arc.Plane);
    }

    public static Arc ReadArc(this BinaryReader reader) => new(reader.ReadPoint(), reader.ReadDouble(), (ArcPlane)reader.ReadByte());
}
