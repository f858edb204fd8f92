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
            w.WriteList(toolpath.Blocks, block => ColumnBytes.Write(w, block.Columns));
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

    private static ToolpathColumns ReadColumns(BinaryReader r, int layers)
    {
        var c = ColumnBytes.Read(r);
        return Array.TrueForAll(c.Layer, l => l >= -1 && l < layers) ? c : throw new InvalidDataException();
    }
}
