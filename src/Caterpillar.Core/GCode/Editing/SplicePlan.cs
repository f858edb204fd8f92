using System;
using System.Collections.Generic;
using Caterpillar.Toolpaths;

namespace Caterpillar.GCode;

/// <summary>Which chunks of a file an edited toolpath touches.</summary>
internal sealed class SplicePlan
{
    private readonly Checkpoint[] _checkpoints;
    private readonly bool[] _dirty;
    private readonly Dictionary<PrinterEvent, int> _places = new(ReferenceComparer.Instance);

    private SplicePlan(Checkpoint[] checkpoints)
    {
        _checkpoints = checkpoints;
        _dirty = new bool[checkpoints.Length];
    }

    /// <summary>False where the moves are in another order than their lines.</summary>
    public bool InOrder { get; private set; } = true;

    /// <summary>The events of the edited toolpath, and of each whether it is not in the file.</summary>
    public IReadOnlyList<MoveEvent> Events { get; private set; } = [];

    public bool[] IsNew { get; private set; } = [];

    /// <summary>Where an event of the file stands among <see cref="Events"/>; −1 where it is gone.</summary>
    public int PlaceOf(PrinterEvent what) => _places.TryGetValue(what, out var place) ? place : -1;

    public bool IsDirty(int chunk) => _dirty[chunk];

    /// <summary>The chunks with these lines are gone through line by line.</summary>
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
        var known = new HashSet<PrinterEvent>(ReferenceComparer.Instance);
        foreach (var old in decoding.Toolpath.Events) known.Add(old.Event);
        plan.Events = edited.Events;
        plan.IsNew = new bool[edited.Events.Count];
        for (var i = 0; i < plan.IsNew.Length; i++)
        {
            var now = edited.Events[i];
            plan.IsNew[i] = !known.Contains(now.Event);
            if (plan.IsNew[i]) plan.MarkMove(edited, now.Move);
            else plan._places[now.Event] = i;
        }
        if (!ReferenceEquals(decoding.Toolpath, edited)) plan.Compare(decoding.Toolpath, edited);
        return plan;
    }

    private void Compare(Toolpath before, Toolpath after)
    {
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
                if (p.Source < last) InOrder = false;
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
        // The first move behind a shared block may follow an insertion at its end.
        InOrder &= IsAscending(after);
    }

    private static bool IsAscending(Toolpath toolpath)
    {
        var last = int.MinValue;
        foreach (var block in toolpath.Blocks)
        {
            var sources = block.Columns.Source;
            for (var i = 0; i < block.Count; i++)
            {
                if (sources[i] < 0) continue;
                if (sources[i] < last) return false;
                last = sources[i];
            }
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
        int low = 0, high = _checkpoints.Length - 1;
        while (low < high)
        {
            var middle = (low + high + 1) / 2;
            if (_checkpoints[middle].Line < line) low = middle;
            else high = middle - 1;
        }
        if (low < _dirty.Length) _dirty[low] = true;
    }

    private sealed class ReferenceComparer : IEqualityComparer<PrinterEvent>
    {
        public static readonly ReferenceComparer Instance = new();

        public bool Equals(PrinterEvent? x, PrinterEvent? y) => ReferenceEquals(x, y);

        public int GetHashCode(PrinterEvent obj) => System.Runtime.CompilerServices.RuntimeHelpers.GetHashCode(obj);
    }
}

/// <summary>Goes through the moves of a toolpath, optionally leaving out some blocks.</summary>
internal sealed class MoveCursor
{
    private readonly Toolpath _toolpath;
    private readonly HashSet<ToolpathBlock>? _skip;
    private int _block = -1;

    public MoveCursor(Toolpath toolpath, HashSet<ToolpathBlock>? skip = null)
    {
        _toolpath = toolpath;
        _skip = skip;
        NextBlock();
    }

    public MoveCursor Clone() => (MoveCursor)MemberwiseClone();

    public ToolpathColumns Columns { get; private set; } = null!;

    public int Index { get; private set; }

    public bool Valid => _block < _toolpath.Blocks.Count;

    public int Source => Columns.Source[Index];

    /// <summary>Number of the move in its toolpath.</summary>
    public int Number => Valid ? _toolpath.FirstOf(_block) + Index : _toolpath.Count;

    public void Next()
    {
        if (++Index >= Columns.Count) NextBlock();
    }

    /// <summary>Goes on to the first move whose line is not before this one.</summary>
    public void SkipTo(int line)
    {
        while (Valid)
        {
            var last = Columns.Source[Columns.Count - 1];
            if (last >= 0 && last < line) NextBlock();
            else if (Source < line && LeadsTo() < line) Next();
            else return;
        }
    }

    /// <summary>The line of the next move that has one, or the largest number.</summary>
    public int LeadsTo()
    {
        if (!Valid || Source >= 0) return Valid ? Source : int.MaxValue;
        var ahead = Clone();
        while (ahead.Valid && ahead.Source < 0) ahead.Next();
        return ahead.Valid ? ahead.Source : int.MaxValue;
    }

    public Wanted Wanted() => new(Columns, Index);

    public static bool Same(MoveCursor a, MoveCursor b)
    {
        var x = a.Wanted();
        var y = b.Wanted();
        return x == y;
    }

    private void NextBlock()
    {
        Index = 0;
        do _block++;
        while (_block < _toolpath.Blocks.Count && _skip is not null && _skip.Contains(_toolpath.Blocks[_block]));
        if (Valid) Columns = _toolpath.Blocks[_block].Columns;
    }
}

/// <summary>What a line has to do.</summary>
internal readonly record struct Wanted(double X, double Y, double Z, double E, double Speed, MoveKind Kind, int Tool, Geometry.Arc? Arc, Turns Turns)
{
    public Wanted(ToolpathColumns c, int i)
        : this(
            c.X[i], c.Y[i], c.Z[i], c.E[i], c.Speed[i], c.Kind[i], c.Tool[i], c.TryGetArc(i, out var arc) ? arc : null,
            c.A is null ? default : new Turns(c.A[i], c.B![i], c.C![i]))
    {
    }
}
