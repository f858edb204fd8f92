namespace Caterpillar.GH.Preview;

/// <summary>
/// The extrusions of some moves as lines, in order and in blocks, about a hundred of many, so that the part up to any move is drawn in few calls. Only the
/// block in which that part ends is copied when it moves, into one array that is used again.
/// </summary>
internal sealed class PrintedLines
{
    private const int MostBlocks = 100;
    private const int LeastBlock = 1024;
    private readonly List<Rg.Line[]> _blocks = [];
    private readonly int[] _firsts;
    private readonly int _size;

    /// <param name="moves">Number of moves.</param>
    /// <param name="add">Adds the lines of a move, if it prints.</param>
    public PrintedLines(int moves, Action<int, List<Rg.Line>> add)
    {
        _size = Math.Max(LeastBlock, (moves + MostBlocks - 1) / MostBlocks);
        _firsts = new int[moves + 1];
        var lines = new List<Rg.Line>(_size);
        var box = Rg.BoundingBox.Empty;
        for (var i = 0; i < moves; i++)
        {
            _firsts[i] = _blocks.Count * _size + lines.Count;
            add(i, lines);
            while (lines.Count >= _size) Close(lines, _size, ref box);
        }
        _firsts[moves] = _blocks.Count * _size + lines.Count;
        if (lines.Count > 0) Close(lines, lines.Count, ref box);
        End = new Rg.Line[_size];
        Box = box;
    }

    /// <summary>Bounds of all of it, in document units.</summary>
    public Rg.BoundingBox Box { get; }

    public int Count => _firsts[_firsts.Length - 1];

    /// <summary>Number of whole blocks that are drawn now.</summary>
    public int Blocks { get; private set; }

    /// <summary>The lines after the whole blocks. Lines that are not printed yet are at one point.</summary>
    public Rg.Line[] End { get; }

    public static PrintedLines Of(Toolpath toolpath, DocumentUnits units, CancellationToken cancel = default) => new(toolpath.Count, (i, lines) =>
    {
        if (i % 65536 == 0) cancel.ThrowIfCancellationRequested();
        var move = toolpath[i];
        if (move.Kind == MoveKind.Print) RhinoGeometry.AddLines(lines, move.Start, move.End, move.Arc, units);
    });

    /// <summary>Shows the moves before one, and a part of that from 0 to 1 of its lines.</summary>
    public void ShowUntil(int move, double done)
    {
        var from = _firsts[Math.Min(move, _firsts.Length - 1)];
        var chords = move + 1 < _firsts.Length ? _firsts[move + 1] - from : 0;
        var along = done * chords;
        var whole = from + (int)along;
        Blocks = whole / _size;
        var rest = whole - Blocks * _size;
        if (Blocks < _blocks.Count) Array.Copy(_blocks[Blocks], End, rest);
        var last = rest > 0 ? End[rest - 1].To : Blocks > 0 ? _blocks[Blocks - 1][_size - 1].To : Count > 0 ? _blocks[0][0].From : Rg.Point3d.Origin;
        if (along > (int)along && Blocks < _blocks.Count)
        {
            var line = _blocks[Blocks][rest];
            last = line.PointAt(along - (int)along);
            End[rest++] = new Rg.Line(line.From, last);
        }
        for (var i = rest; i < End.Length; i++) End[i] = new Rg.Line(last, last);
    }

    public void Draw(DisplayPipeline display, System.Drawing.Color color, int thickness)
    {
        for (var b = 0; b < Blocks; b++) display.DrawLines(_blocks[b], color, thickness);
        if (Count > 0) display.DrawLines(End, color, thickness);
    }

    private void Close(List<Rg.Line> lines, int count, ref Rg.BoundingBox box)
    {
        var block = new Rg.Line[count];
        lines.CopyTo(0, block, 0, count);
        lines.RemoveRange(0, count);
        foreach (var line in block)
        {
            box.Union(line.From);
            box.Union(line.To);
        }
        _blocks.Add(block);
    }
}
