namespace Caterpillar.GCode;

/// <summary>Finds the chunks of a file that an edited toolpath changes.</summary>
internal sealed class SplicePlan(Checkpoint[] checkpoints)
{
    private readonly Checkpoint[] _checkpoints = checkpoints;
    private readonly bool[] _dirty = new bool[checkpoints.Length];

    // The lines of the chunk that was marked last.
    private (int After, int Last) _marked;
    private readonly Dictionary<PrinterEvent, int> _indices = new(ReferenceComparer.Instance);

    /// <summary>False if the moves are not in the order of their lines.</summary>
    public bool InOrder { get; private set; } = true;

    /// <summary>The events of the edited toolpath, and for each whether it is new.</summary>
    public IReadOnlyList<MoveEvent> Events { get; private set; } = [];

    public bool[] IsNew { get; private set; } = [];

    /// <summary>Index of an event of the file in <see cref="Events"/>. −1 = removed.</summary>
    public int IndexOf(PrinterEvent what) => _indices.TryGetValue(what, out var index) ? index : -1;

    public bool IsDirty(int chunk) => _dirty[chunk];

    /// <summary>The chunks with these lines are spliced line by line.</summary>
    public void Touch(int firstLine, int lastLine)
    {
        for (var i = 0; i < _dirty.Length; i++)
        {
            var next = i + 1 < _checkpoints.Length ? _checkpoints[i + 1].Line : int.MaxValue;
            if (_checkpoints[i].Line < lastLine && next >= firstLine) _dirty[i] = true;
        }
    }

    public static SplicePlan Of(DecodedGCode decoding, Toolpath edited)
    {
        var plan = new SplicePlan(decoding.Checkpoints);
        var known = new HashSet<PrinterEvent>(decoding.Toolpath.Events.Select(old => old.Event), ReferenceComparer.Instance);
        plan.Events = edited.Events;
        plan.IsNew = new bool[edited.Events.Count];
        for (var i = 0; i < plan.IsNew.Length; i++)
        {
            var now = edited.Events[i];
            plan.IsNew[i] = !known.Contains(now.Event);
            if (plan.IsNew[i]) plan.MarkMove(edited, now.Move);
            else plan._indices[now.Event] = i;
        }
        if (!ReferenceEquals(decoding.Toolpath, edited)) plan.Compare(decoding.Toolpath, edited);
        return plan;
    }

    private void Compare(Toolpath before, Toolpath after)
    {
        InOrder = IsAscending(after);
        var kept = new HashSet<ToolpathBlock>(after.Blocks);
        kept.IntersectWith(before.Blocks);
        var o = new MoveCursor(before, kept);
        var p = new MoveCursor(after, kept);
        var last = int.MinValue;
        var inserted = false;
        while (true)
        {
            while (p.Valid && p.Source < 0)
            {
                inserted = true;
                p.Next();
            }
            if (p.Valid)
            {
                last = p.Source;
                if (inserted) Mark(p.Source);
                inserted = false;
            }
            if (!p.Valid && !o.Valid) break;
            if (p.Valid && o.Valid && p.Source == o.Source)
            {
                if (!MoveCursor.Same(o, p)) Mark(p.Source);
                o.Next();
                p.Next();
            }
            else if (!o.Valid || (p.Valid && p.Source < o.Source))
            {
                Mark(p.Source);
                p.Next();
            }
            else
            {
                Mark(o.Source);
                o.Next();
            }
        }
        if (inserted) Mark(last == int.MinValue ? 1 : last);
    }

    private static bool IsAscending(Toolpath toolpath)
    {
        var last = int.MinValue;
        foreach (var lines in toolpath.Blocks.Select(b => b.Summary))
        {
            if (!lines.Ascends || lines.First < last) return false;
            last = Math.Max(last, lines.Last);
        }
        return true;
    }

    private void MarkMove(Toolpath toolpath, int move)
    {
        for (var i = Math.Min(move, toolpath.Count - 1); i >= 0 && i < toolpath.Count; i++)
        {
            if (toolpath[i].Source < 0) continue;
            Mark(toolpath[i].Source);
            return;
        }
        if (_dirty.Length > 0) _dirty[_dirty.Length - 1] = true;
    }

    private void Mark(int line)
    {
        if (line > _marked.After && line <= _marked.Last) return;
        var chunk = Search.First(1, _checkpoints.Length, (_checkpoints, line), static (s, i) => s._checkpoints[i].Line >= s.line) - 1;
        if (chunk >= _dirty.Length) return;
        _dirty[chunk] = true;
        _marked = (_checkpoints[chunk].Line, chunk + 1 < _checkpoints.Length ? _checkpoints[chunk + 1].Line : int.MaxValue);
    }

    private sealed class ReferenceComparer : IEqualityComparer<PrinterEvent>
    {
        public static readonly ReferenceComparer Instance = new();

        public bool Equals(PrinterEvent? x, PrinterEvent? y) => ReferenceEquals(x, y);

        public int GetHashCode(PrinterEvent obj) => System.Runtime.CompilerServices.RuntimeHelpers.GetHashCode(obj);
    }
}
