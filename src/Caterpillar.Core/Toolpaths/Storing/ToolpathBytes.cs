namespace Caterpillar.Toolpaths;

/// <summary>Toolpaths as compressed bytes, for files that hold them. Nothing of a toolpath is lost.</summary>
public static class ToolpathBytes
{
    /// <summary>The toolpath as bytes.</summary>
    public static byte[] Pack(Toolpath toolpath)
    {
        if (toolpath is null) throw new ArgumentNullException(nameof(toolpath));
        return Packed.Pack(w =>
        {
            w.Write((byte)toolpath.Source);
            w.Write(toolpath.Start is not null);
            if (toolpath.Start is { } start) w.Write(start);
            w.WriteList(toolpath.Layers, w.WriteRecord);
            w.WriteList(toolpath.Tools, w.WriteRecord);
            w.WriteList(toolpath.Places, w.WriteRecord);
            w.WriteList(toolpath.Events, e =>
            {
                w.Write(e.Move);
                w.Write(e.Source);
                w.WriteEvent(e.Event);
            });
            w.WriteList(toolpath.Blocks, block => Write(w, block.Columns));
        });
    }

    /// <summary>The toolpath in bytes. Null if they are damaged or of a later version.</summary>
    public static Toolpath? Unpack(byte[] bytes) => Packed.Unpack(bytes, r =>
    {
        var source = (MoveSource)r.ReadByte();
        var start = r.ReadBoolean() ? r.ReadPoint() : (Geometry.Vec3?)null;
        var layers = r.ReadList(() => r.ReadRecord<Layer>() ?? throw new InvalidDataException());
        var tools = r.ReadList(() => r.ReadRecord<ToolpathTool>() ?? throw new InvalidDataException());
        var places = r.ReadList(r.ReadRecord<SourceLocation>);
        var events = r.ReadList(() => (Move: r.ReadInt32(), Source: r.ReadInt32(), Event: r.ReadEvent()))
            .ConvertAll(e => new MoveEvent(e.Move, e.Event) { Source = e.Source });
        var blocks = r.ReadList(() => new ToolpathBlock(ReadColumns(r, layers.Count)));
        return new Toolpath(blocks, layers, events, tools, start, source, places);
    });

    // Column by column: equal values are neighbors, which packs well.
    private static void Write(BinaryWriter w, ToolpathColumns c)
    {
        w.Write(c.Count);
        double[]?[] numbers = [c.X, c.Y, c.Z, c.E, c.Deposited, c.Speed, c.A, c.B, c.C];
        foreach (var column in numbers) Write(w, column, c.Count, w.Write);
        int[]?[] integers = [c.Layer, c.Source, c.Line];
        foreach (var column in integers) Write(w, column, c.Count, w.Write);
        for (var i = 0; i < c.Count; i++) w.Write((byte)c.Kind[i]);
        for (var i = 0; i < c.Count; i++) w.Write((byte)c.Role[i]);
        for (var i = 0; i < c.Count; i++) w.Write(c.Tool[i]);
        w.WriteList(c.ArcMoves, w.Write);
        w.WriteList(c.Arcs, w.Write);
    }

    private static ToolpathColumns ReadColumns(BinaryReader r, int layers)
    {
        var count = r.ReadInt32();
        if (count is <= 0 or > ToolpathBlock.Capacity) throw new InvalidDataException();
        double[] Numbers() => Read(r, count, r.ReadDouble) ?? throw new InvalidDataException();
        int[] Integers() => Read(r, count, r.ReadInt32) ?? throw new InvalidDataException();
        var c = new ToolpathColumns(0)
        {
            Count = count,
            X = Numbers(), Y = Numbers(), Z = Numbers(), E = Numbers(), Deposited = Numbers(), Speed = Numbers(),
            A = Read(r, count, r.ReadDouble), B = Read(r, count, r.ReadDouble), C = Read(r, count, r.ReadDouble),
            Layer = Integers(), Source = Integers(), Line = Read(r, count, r.ReadInt32),
            Kind = new MoveKind[count], Role = new Role[count], Tool = new short[count],
        };
        for (var i = 0; i < count; i++) c.Kind[i] = Known((MoveKind)r.ReadByte());
        for (var i = 0; i < count; i++) c.Role[i] = Known((Role)r.ReadByte());
        for (var i = 0; i < count; i++) c.Tool[i] = r.ReadInt16();
        c.ArcMoves = r.ReadList(r.ReadInt32).ToArray();
        c.Arcs = r.ReadList(r.ReadArc).ToArray();
        return Array.TrueForAll(c.Layer, l => l >= -1 && l < layers) && c.Arcs.Length == c.ArcMoves.Length ? c : throw new InvalidDataException();
    }

    private static void Write<T>(BinaryWriter w, T[]? column, int count, Action<T> write)
    {
        w.Write(column is not null);
        for (var i = 0; i < count && column is not null; i++) write(column[i]);
    }

    private static T[]? Read<T>(BinaryReader r, int count, Func<T> read)
    {
        if (!r.ReadBoolean()) return null;
        var column = new T[count];
        for (var i = 0; i < count; i++) column[i] = read();
        return column;
    }

    private static T Known<T>(T value)
        where T : struct, Enum
        => Enum.IsDefined(typeof(T), value) ? value : throw new InvalidDataException();
}
