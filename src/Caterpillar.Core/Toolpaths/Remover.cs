using System;
using System.Collections.Generic;
using Caterpillar.Geometry;

namespace Caterpillar.Toolpaths;

/// <summary>Cuts moves out of a toolpath and mends what the cut leaves open; blocks without cuts are shared.</summary>
internal sealed class Remover(Toolpath toolpath, Func<Move, bool> removes)
{
    private const double NoChange = 1e-9;
    private readonly List<ToolpathBlock> _blocks = [];
    private readonly List<MoveEvent> _events = [];
    private readonly Dictionary<int, double> _retractedBefore = [];
    private readonly Dictionary<int, double> _retractedNow = [];
    private BlockEditor? _editor;
    private Vec3 _position = toolpath.Start ?? Vec3.Zero;
    private double _travelSpeed;
    private double _retractSpeed;
    private int _made;
    private int _nextEvent;
    private bool _open;

    public Toolpath Run()
    {
        for (var block = 0; block < toolpath.Blocks.Count; block++)
        {
            var first = toolpath.FirstOf(block);
            var count = toolpath.Blocks[block].Count;
            var cuts = false;
            for (var i = first; i < first + count && !cuts; i++) cuts = removes(toolpath[i]);
            if (!cuts && !_open)
            {
                for (var i = first; i < first + count; i++) Note(toolpath[i], true);
                Events(first + count);
                _blocks.Add(toolpath.Blocks[block]);
                _made += count;
                continue;
            }
            _editor = new BlockEditor();
            for (var i = first; i < first + count; i++) Step(toolpath[i]);
            _blocks.AddRange(_editor.ToBlocks());
        }
        Events(int.MaxValue);
        return toolpath.WithBlocks(_blocks, _events);
    }

    private void Step(Move move)
    {
        if (removes(move))
        {
            Note(move, false);
            _open = true;
            return;
        }
        Events(move.Index);
        if (_open) Mend(move);
        Add(move.End, move.E, move.Deposited, move.Speed, move.Kind, move.Role, move.Layer, move.Tool, move.Source, move.Arc);
        Note(move, true);
    }

    // What is pulled back before and after a move, in the file and in what is left of it.
    private void Note(Move move, bool kept)
    {
        var pulled = move.E < 0 ? -move.E : -(move.E - move.Deposited);
        if (pulled != 0)
        {
            _retractedBefore[move.Tool] = Sum(_retractedBefore, move.Tool) + pulled;
            if (kept) _retractedNow[move.Tool] = Sum(_retractedNow, move.Tool) + pulled;
        }
        if (move.Kind == MoveKind.Travel && move.Speed > 0) _travelSpeed = move.Speed;
        if (move.Kind == MoveKind.Retract && move.Speed > 0) _retractSpeed = move.Speed;
        if (kept) _position = move.End;
    }

    private void Mend(Move move)
    {
        var missing = Sum(_retractedBefore, move.Tool) - Sum(_retractedNow, move.Tool);
        if (missing > NoChange) Pull(move, missing);
        // A travel begins anywhere; everything else where it began.
        var needsStart = move.Kind != MoveKind.Travel || move.Arc is not null;
        if (needsStart) Travel(move);
        if (missing < -NoChange) Pull(move, missing);
        _open = false;
    }

    private void Travel(Move move)
    {
        var to = move.Start;
        if (to == _position) return;
        var speed = _travelSpeed > 0 ? _travelSpeed : move.Speed;
        // Up before across, across before down.
        var corner = to.Z > _position.Z ? _position.WithZ(to.Z) : to.WithZ(_position.Z);
        if (corner != _position && corner != to) Add(corner, 0, 0, speed, MoveKind.Travel, Role.Unspecified, move.Layer, move.Tool, -1, null);
        Add(to, 0, 0, speed, MoveKind.Travel, Role.Unspecified, move.Layer, move.Tool, -1, null);
        _position = to;
    }

    private void Pull(Move move, double amount)
    {
        var speed = _retractSpeed > 0 ? _retractSpeed : 30;
        Add(_position, -amount, 0, speed, amount > 0 ? MoveKind.Retract : MoveKind.Restore, Role.Unspecified, move.Layer, move.Tool, -1, null);
        _retractedNow[move.Tool] = Sum(_retractedNow, move.Tool) + amount;
    }

    private void Add(Vec3 end, double e, double deposited, double speed, MoveKind kind, Role role, int layer, int tool, int source, Arc? arc)
    {
        _editor!.Add(end, e, deposited, speed, kind, role, layer, tool, source, arc);
        _made++;
    }

    private void Events(int before)
    {
        for (; _nextEvent < toolpath.Events.Count && toolpath.Events[_nextEvent].Move <= before; _nextEvent++)
            _events.Add(new MoveEvent(_made, toolpath.Events[_nextEvent].Event));
    }

    private static double Sum(Dictionary<int, double> sums, int tool) => sums.TryGetValue(tool, out var sum) ? sum : 0;
}
