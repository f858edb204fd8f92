namespace Caterpillar.GCode;

/// <content>Fast path for extrusions that follow each other at one height, as most lines of a print do, without checking the state again.</content>
internal sealed partial class MoveRecorder
{
    private const double LongestExtrusion2 = 1e6;
    private const double LeastFlow = 1e-6;

    /// <summary>
    /// Executes the lines of a chunk as long as they are straight extrusions after an extrusion at the same height, in modes without special cases. The result
    /// is the same as with <see cref="Line"/>.
    /// </summary>
    /// <returns>The first other line.</returns>
    [MethodImpl(Compile.Optimized)]
    public int Extrusions(LineRecord[] records, int next, int end, int firstLine)
    {
        ref var head = ref _state.Head;
        var flow = _balance ? _state.Extrusion.Flow : 1;
        if (!_afterPrint || head.Z != _lastPrintZ || head.Z != _lastFlatZ || Layers.NeedsZ || _extruders.IsRetracted || !(flow > LeastFlow)) return next;
        var c = _moves.Columns;
        var from = c.Count;
        end = Math.Min(end, next + c.Capacity - from);
        double[] columnX = c.X, columnY = c.Y, columnE = c.E, deposits = c.Deposited;
        var source = c.Source;
        var relative = _state.Modes.RelativeE;
        var (x, y, shiftX, shiftY, position) = (head.X, head.Y, head.ShiftX, head.ShiftY, _state.Extrusion.E);
        var (length, lengthXY, printed) = (_counters.PrintLength, _counters.PrintLengthXY, _counters.EPrint);
        var (sum, highest) = _extruders.Running;
        var (positive, net) = (_counters.EPositive, _counters.ENet);
        var ends = _counters.PrintEnds;
        double minX = ends.MinX, minY = ends.MinY, maxX = ends.MaxX, maxY = ends.MaxY;
        var i = from;
        for (; next < end; next++, i++)
        {
            ref var record = ref records[next];
            int mask = record.Mask;
            if (record.Op != 1 || record.Aux >= 0 || (mask & (ChunkParser.HasE | ChunkParser.HasF | ChunkParser.HasZ)) != ChunkParser.HasE) break;
            var toX = (mask & ChunkParser.HasX) != 0 ? record.X : x;
            var toY = (mask & ChunkParser.HasY) != 0 ? record.Y : y;
            var e = relative ? record.E : record.E - position;
            var dx = toX - x;
            var dy = toY - y;
            var square = dx * dx + dy * dy;
            if (!(square > NoChange * NoChange && square <= LongestExtrusion2 && e >= NoChange && e < LargestE && Math.Abs(record.E) < LargestE)) break;
            var along = Math.Sqrt(square);
            var deposited = e * flow;
            x = toX;
            y = toY;
            position += e;
            length += along;
            lengthXY += along;
            printed += deposited;
            positive += e;
            net += e;
            sum += e;
            if (sum > highest) highest = sum;
            if (x < minX) minX = x;
            if (x > maxX) maxX = x;
            if (y < minY) minY = y;
            if (y > maxY) maxY = y;
            columnX[i] = x + shiftX;
            columnY[i] = y + shiftY;
            columnE[i] = e;
            deposits[i] = deposited;
            source[i] = firstLine + next + 1;
        }
        if (i == from) return next;
        (head.X, head.Y, _state.Extrusion.E, _state.Modes.Motion) = (x, y, position, 1);
        _extruders.Running = (sum, highest);
        (_counters.EPositive, _counters.ENet, _counters.EPrint) = (positive, net, printed);
        (_counters.PrintLength, _counters.PrintLengthXY) = (length, lengthXY);
        (ends.MinX, ends.MinY, ends.MaxX, ends.MaxY) = (minX, minY, maxX, maxY);
        _counters.Prints += i - from;
        _counters.Feeds += i - from;
        c.Count = i;
        FillRest(c, from, i);
        return next;
    }

    // What stays as it is from extrusion to extrusion.
    private void FillRest(ToolpathColumns c, int from, int to)
    {
        var (z, speed, layer, tool, role) = (_state.Head.Z + _state.Head.ShiftZ, _state.Feed.Speed, Layers.Current, (short)_state.Tool, Role);
        Buffers.Fill(c.Z, from, to, z);
        Buffers.Fill(c.Speed, from, to, speed);
        Buffers.Fill(c.Layer, from, to, layer);
        Buffers.Fill(c.Tool, from, to, tool);
        Buffers.Fill(c.Kind, from, to, MoveKind.Print);
        Buffers.Fill(c.Role, from, to, role);
        _moves.HoldTurns(from, to);
    }
}
