using System;
using System.Collections.Generic;
using Caterpillar.Geometry;

namespace Caterpillar.Toolpaths;

/// <summary>Maps the points of chosen moves; blocks without any are shared.</summary>
internal sealed class Deformer(Toolpath toolpath, MoveFilter filter, Func<Vec3, Vec3> map, double tolerance)
{
    private readonly List<ToolpathBlock> _blocks = [];
    private readonly List<MoveEvent> _events = [];
    private BlockEditor? _editor;
    private int _made;
    private int _nextEvent;

    public Toolpath Run()
    {
        if (toolpath.Count == 0) return toolpath;
        var chosen = new bool[toolpath.Count];
        foreach (var move in toolpath.Moves()) chosen[move.Index] = filter.Matches(toolpath, move);
        var start = toolpath.Start ?? Vec3.Zero;
        for (var block = 0; block < toolpath.Blocks.Count; block++)
        {
            var first = toolpath.FirstOf(block);
            var count = toolpath.Blocks[block].Count;
            if (!Touched(chosen, first, count))
            {
                Events(first + count);
                _blocks.Add(toolpath.Blocks[block]);
                _made += count;
                start = toolpath[first + count - 1].End;
                continue;
            }
            _editor = new BlockEditor();
            for (var i = first; i < first + count; i++) start = Map(toolpath[i], chosen, start);
            _blocks.AddRange(_editor.ToBlocks());
        }
        Events(int.MaxValue);
        return toolpath.WithBlocks(_blocks, _events);
    }

    // The end of a move goes with it, or with the strand that begins there.
    private bool Mapped(bool[] chosen, int i)
        => chosen[i] || (i + 1 < chosen.Length && chosen[i + 1] && toolpath[i].Kind != MoveKind.Print && toolpath[i + 1].Kind == MoveKind.Print);

    private bool Touched(bool[] chosen, int first, int count)
    {
        for (var i = Math.Max(first - 1, 0); i < first + count; i++)
        {
            if (Mapped(chosen, i)) return true;
        }
        return false;
    }

    private Vec3 Map(Move move, bool[] chosen, Vec3 start)
    {
        Events(move.Index);
        var mapped = Mapped(chosen, move.Index);
        var end = mapped ? map(move.End) : move.End;
        if (!end.IsFinite) throw new InvalidOperationException("The map gives a point that is not finite.");
        var changed = mapped || start != move.Start;
        if (!changed)
        {
            Add(move, move.End, move.E, move.Deposited, move.Arc);
            return move.End;
        }
        var length = move.Length;
        var chords = move.Arc is { } arc ? arc.ChordCount(move.Start, tolerance) : 1;
        var from = start;
        for (var k = 1; k <= chords; k++)
        {
            var to = end;
            if (k < chords)
            {
                var point = move.Arc!.Value.PointAt(move.Start, move.End, (double)k / chords);
                to = mapped ? map(point) : point;
            }
            var share = 1.0 / chords;
            var deposited = move.Kind == MoveKind.Print && length > 0 ? move.Deposited / length * from.DistanceTo(to) : move.Deposited * share;
            Add(move, to, move.E * share + (deposited - move.Deposited * share), deposited, null);
            from = to;
        }
        return end;
    }

    private void Add(Move move, Vec3 end, double e, double deposited, Arc? arc)
    {
        _editor!.Add(end, e, deposited, move.Speed, move.Kind, move.Role, move.Layer, move.Tool, move.Source, arc);
        _made++;
    }

    private void Events(int before)
    {
        for (; _nextEvent < toolpath.Events.Count && toolpath.Events[_nextEvent].Move <= before; _nextEvent++)
            _events.Add(new MoveEvent(_made, toolpath.Events[_nextEvent].Event));
    }
}

/// <summary>Collects the moves of an edited block.</summary>
internal sealed class BlockEditor
{
    private readonly ToolpathBuilder _builder = new(MoveSource.Lines, null);

    public void Add(Vec3 end, double e, double deposited, double speed, MoveKind kind, Role role, int layer, int tool, int source, Arc? arc)
        => _builder.Add(end, e, deposited, speed, kind, role, layer, tool, source, arc);

    public IReadOnlyList<ToolpathBlock> ToBlocks() => _builder.Build([]).Blocks;
}
