namespace Caterpillar.GCode;

/// <summary>
/// The lines of each move, event and template in a file, from 1. While one thread records them, others may read the recorded ones. The file may have more lines
/// that were added later.
/// </summary>
internal sealed class WrittenLines
{
    private const int PartSize = 1 << 14;

    // Replaced as a whole where there are more: what others read of it never changes.
    private volatile Part[] _parts = [];
    private readonly List<(int Before, int Last, int Event)> _events = [];
    private readonly List<int> _added = [];
    private int _start;
    private int _end = int.MaxValue;
    private volatile int _moves;

    /// <summary>Number of written moves.</summary>
    public int Moves => _moves;

    public void EndStart(long lines) => _start = Number(lines);

    public void BeginEnd(long lines) => _end = Number(lines);

    public void BeginMove(int move, long lines)
    {
        if (move / PartSize == _parts.Length) _parts = [.. _parts, new Part()];
        _parts[move / PartSize].Before[move % PartSize] = Number(lines);
    }

    public void EndMove(int move, long lines)
    {
        _parts[move / PartSize].Last[move % PartSize] = Number(lines);
        _moves = move + 1;
    }

    public void Event(int index, long before, long last)
    {
        if (last <= before) return;
        lock (_events) _events.Add((Number(before), Number(last), index));
    }

    /// <summary>Adds a line of the file after this many recorded lines, in ascending order.</summary>
    public void Add(int after) => _added.Add(after);

    /// <summary>The number of a line in the file.</summary>
    public int InFile(int line)
    {
        var added = 0;
        while (added < _added.Count && _added[added] < line) added++;
        return line + added;
    }

    /// <summary>Number of lines before an event of a move.</summary>
    public int Before(int move, int what) => LineOf(what) is > 0 and var line ? line - 1 : move > 0 ? OfMove(move - 1).Last : _start;

    /// <summary>True for lines of the start or end G-code.</summary>
    public bool IsStart(int line) => line <= _start;

    /// <inheritdoc cref="IsStart"/>
    public bool IsEnd(int line) => line > _end;

    /// <summary>First and last line of a move. The last is before the first if nothing was written.</summary>
    public (int First, int Last) OfMove(int move)
    {
        var (part, at) = (_parts[(uint)move / PartSize], (uint)move % PartSize);
        return (part.Before[at] + 1, part.Last[at]);
    }

    /// <summary>The move of a line, or −1.</summary>
    public int MoveAt(int line)
    {
        var move = NextMove(line);
        return move < _moves && line >= OfMove(move).First ? move : -1;
    }

    /// <summary>The first move whose last line is not before a line. Number of moves = none.</summary>
    public int NextMove(int line) => Search.First(0, _moves, (Lines: this, line), (s, move) => s.Lines.OfMove(move).Last >= s.line);

    /// <summary>The event of a line, or −1.</summary>
    public int EventAt(int line)
    {
        lock (_events)
        {
            var at = Search.First(0, _events.Count, (_events, line), (s, i) => s._events[i].Last >= s.line);
            return at < _events.Count && line > _events[at].Before ? _events[at].Event : -1;
        }
    }

    /// <summary>The first line of an event. 0 = none.</summary>
    public int LineOf(int what)
    {
        lock (_events)
        {
            var at = Search.First(0, _events.Count, (_events, what), (s, i) => s._events[i].Event >= s.what);
            return at < _events.Count && _events[at].Event == what ? _events[at].Before + 1 : 0;
        }
    }

    private static int Number(long lines) => (int)Math.Min(lines, int.MaxValue);

    // Lines before moves, and last lines of them.
    private sealed class Part
    {
        public readonly int[] Before = new int[PartSize];
        public readonly int[] Last = new int[PartSize];
    }
}
