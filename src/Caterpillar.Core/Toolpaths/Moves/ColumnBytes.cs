namespace Caterpillar.Toolpaths;

/// <summary>The columns of a block as bytes, without loss. Of equal values in sequence, only the first is written, with their number.</summary>
internal static class ColumnBytes
{
    public static void Write(BinaryWriter w, ToolpathColumns c)
    {
        w.Write(c.Count);
        foreach (var column in new[] { c.X, c.Y, c.E }) WriteAll(w, column, c.Count);
        WriteRuns(w, c.Count, i => Bits(c.Z[i]));
        WriteRuns(w, c.Count, i => Bits(c.E[i]) ^ Bits(c.Deposited[i]));
        WriteRuns(w, c.Count, i => Bits(c.Speed[i]));
        WriteRuns(w, c.Count, i => (long)c.Kind[i]);
        WriteRuns(w, c.Count, i => (long)c.Role[i]);
        WriteRuns(w, c.Count, i => c.Tool[i]);
        WriteRuns(w, c.Count, i => c.Layer[i]);
        WriteRuns(w, c.Count, i => (long)c.Source[i] - (i > 0 ? c.Source[i - 1] : 0));
        w.Write(c.Line is not null);
        if (c.Line is { } lines) WriteRuns(w, c.Count, i => lines[i]);
        foreach (var axis in new Func<Vec3, double>[] { turn => turn.X, turn => turn.Y, turn => turn.Z })
        {
            w.Write(c.Turns is not null);
            if (c.Turns is { } turns) WriteAll(w, turns.Take(c.Count).Select(axis).ToArray(), c.Count);
        }
        w.WriteList(c.ArcMoves, w.Write);
        w.WriteList(c.Arcs, w.Write);
    }

    /// <exception cref="InvalidDataException">The bytes are damaged.</exception>
    public static ToolpathColumns Read(BinaryReader r)
    {
        var count = r.ReadInt32();
        if (count is <= 0 or > ToolpathBlock.Capacity) throw new InvalidDataException();
        var c = new ToolpathColumns(count) { Count = count };
        foreach (var column in new[] { c.X, c.Y, c.E }) ReadAll(r, column);
        ReadRuns(r, count, (from, to, bits) => Buffers.Fill(c.Z, from, to, BitConverter.Int64BitsToDouble(bits)));
        ReadRuns(r, count, (from, to, bits) =>
        {
            if (bits == 0) Array.Copy(c.E, from, c.Deposited, from, to - from);
            else for (var i = from; i < to; i++) c.Deposited[i] = BitConverter.Int64BitsToDouble(Bits(c.E[i]) ^ bits);
        });
        ReadRuns(r, count, (from, to, bits) => Buffers.Fill(c.Speed, from, to, BitConverter.Int64BitsToDouble(bits)));
        ReadRuns(r, count, (from, to, value) => Buffers.Fill(c.Kind, from, to, Known((MoveKind)value)));
        ReadRuns(r, count, (from, to, value) => Buffers.Fill(c.Role, from, to, Known((Role)value)));
        ReadRuns(r, count, (from, to, value) => Buffers.Fill(c.Tool, from, to, checked((short)value)));
        ReadRuns(r, count, (from, to, value) => Buffers.Fill(c.Layer, from, to, checked((int)value)));
        ReadRuns(r, count, (from, to, step) =>
        {
            for (var i = from; i < to; i++) c.Source[i] = unchecked((int)((i > 0 ? c.Source[i - 1] : 0) + step));
        });
        if (r.ReadBoolean())
        {
            var lines = c.Line = new int[count];
            ReadRuns(r, count, (from, to, value) => Buffers.Fill(lines, from, to, checked((int)value)));
        }
        double[]? Axis() => r.ReadBoolean() ? ReadAll(r, new double[count]) : null;
        if ((Axis(), Axis(), Axis()) is ({ } x, { } y, { } z)) c.Turns = x.Select((angle, i) => new Vec3(angle, y[i], z[i])).ToArray();
        (c.ArcMoves, c.Arcs) = (r.ReadList(r.ReadInt32).ToArray(), r.ReadList(r.ReadArc).ToArray());
        return c.Arcs.Length == c.ArcMoves.Length ? c : throw new InvalidDataException();
    }

    private static long Bits(double value) => BitConverter.DoubleToInt64Bits(value);

    private static void WriteRuns(BinaryWriter w, int count, Func<int, long> at)
    {
        for (var from = 0; from < count;)
        {
            var (value, to) = (at(from), from + 1);
            while (to < count && at(to) == value) to++;
            w.Write(to - from);
            w.Write(value);
            from = to;
        }
    }

    private static void ReadRuns(BinaryReader r, int count, Action<int, int, long> fill)
    {
        for (var from = 0; from < count;)
        {
            var run = r.ReadInt32();
            if (run <= 0 || run > count - from) throw new InvalidDataException();
            fill(from, from + run, r.ReadInt64());
            from += run;
        }
    }

    private static void WriteAll(BinaryWriter w, double[] column, int count)
    {
        var bytes = new byte[count * sizeof(double)];
        Buffer.BlockCopy(column, 0, bytes, 0, bytes.Length);
        w.Write(bytes);
    }

    private static double[] ReadAll(BinaryReader r, double[] column)
    {
        var bytes = r.ReadBytes(column.Length * sizeof(double));
        if (bytes.Length < column.Length * sizeof(double)) throw new InvalidDataException();
        Buffer.BlockCopy(bytes, 0, column, 0, bytes.Length);
        return column;
    }

    private static T Known<T>(T value)
        where T : struct, Enum
        => Enum.IsDefined(typeof(T), value) ? value : throw new InvalidDataException();
}
