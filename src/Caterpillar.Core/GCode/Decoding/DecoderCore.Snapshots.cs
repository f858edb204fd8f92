using System.Collections.Generic;
using System.Linq;
using Caterpillar.Dialects;
using Caterpillar.Machines;

namespace Caterpillar.GCode;

/// <summary>Saving and restoring the state, and reading one line at a time; for writing a file again.</summary>
internal sealed partial class DecoderCore
{
    /// <summary>Columns of the moves of the last line that was read.</summary>
    public Toolpaths.ToolpathColumns LastMoves => _out.Columns;

    public int ToolNumber => _tool;

    public bool IsSwitchedOn => _switchedOn;

    /// <summary>Events of the last line.</summary>
    public IReadOnlyList<Toolpaths.MoveEvent> LastEvents => _events;

    /// <summary>True where G1 to G3 print without any E.</summary>
    public bool Strokes => _strokes;

    /// <summary>The geometry of the last line's arc, where it made one.</summary>
    public Geometry.Arc? LastArc => _out.LastArc;

    /// <summary>The factor of M221 for the present tool.</summary>
    public double Flow => _flow;

    /// <summary>True when E words are increments now.</summary>
    public bool IsRelativeE => _relativeE;

    /// <summary>
    /// Reads a line and forgets what was before it; returns the number of moves it makes. <paramref name="commands"/> counts motion commands, also those that
    /// move nothing.
    /// </summary>
    public int ReadLine(byte[] text, int start, int end, out int commands)
    {
        _parsed.Scan(text, start, end);
        return ReadLine(_parsed, text, end, out commands);
    }

    /// <summary>The same for a line whose words are known.</summary>
    public int ReadLine(ParsedLine line, byte[] text, int end, out int commands)
    {
        _out.Clear();
        _events.Clear();
        var before = DecodeCounters.Rapids + DecodeCounters.Feeds;
        Execute(line, text, end);
        commands = DecodeCounters.Rapids + DecodeCounters.Feeds - before;
        return _out.Columns.Count;
    }

    public MachineSnapshot Save()
    {
        _state.E = _e;
        return new MachineSnapshot
        {
            X = _x,
            Y = _y,
            Z = _z,
            E = _e,
            ShiftX = _shiftX,
            ShiftY = _shiftY,
            ShiftZ = _shiftZ,
            A = _a,
            B = _b,
            Turns = _turns,
            TurnShift = _turnShift,
            Feed = _feed,
            FeedFactor = _feedFactor,
            Flow = _flow,
            Speed = _speed,
            NextTool = _nextTool,
            ShadowE = _shadowE,
            Tool = _tool,
            Motion = _motion,
            Plane = _plane,
            Relative = _relative,
            Inches = _inches,
            M83 = _m83,
            LastRelative = _lastRelative,
            AbsoluteCenters = _absoluteCenters,
            Shadow = _shadow,
            Volumetric = _volumetric,
            SwitchedOn = _switchedOn,
            KnownX = _knownX,
            KnownY = _knownY,
            KnownZ = _knownZ,
            Started = _started,
            UnitOfE = UnitOfE,
            KeptFactor = _keptFactor,
            Workspace = _system,
            Workspaces = _systems,
            Stored28 = _stored28,
            Stored30 = _stored30,
            Offset = _offset,
            OffsetE = _offsetE,
            ModeStack = _modeStack,
            NamedStates = _namedStates,
            EByTool = _rules.PositionOfE != PositionOfERule.PerTool ? [] : _tools.Select(t => new KeyValuePair<int, double>(t.Key, t.Value.E)).ToArray(),
        };
    }

    public void Restore(MachineSnapshot from)
    {
        foreach (var pair in from.EByTool)
        {
            StateOf(pair.Key).E = pair.Value;
        }
        if (from.Tool != _tool) SelectTool(from.Tool);
        _x = from.X;
        _y = from.Y;
        _z = from.Z;
        _e = from.E;
        _shiftX = from.ShiftX;
        _shiftY = from.ShiftY;
        _shiftZ = from.ShiftZ;
        _a = from.A;
        _b = from.B;
        _turns = from.Turns;
        _turnShift = from.TurnShift;
        _feed = from.Feed;
        _feedFactor = from.FeedFactor;
        _flow = from.Flow;
        _speed = from.Speed;
        _nextTool = from.NextTool;
        _motion = from.Motion;
        _plane = from.Plane;
        _relative = from.Relative;
        _inches = from.Inches;
        _m83 = from.M83;
        _lastRelative = from.LastRelative;
        _absoluteCenters = from.AbsoluteCenters;
        _shadow = from.Shadow;
        _shadowE = from.ShadowE;
        _volumetric = from.Volumetric;
        _switchedOn = from.SwitchedOn;
        _knownX = from.KnownX;
        _knownY = from.KnownY;
        _knownZ = from.KnownZ;
        _started = from.Started;
        _keptFactor = from.KeptFactor;
        _system = from.Workspace;
        _systems = from.Workspaces;
        _stored28 = from.Stored28;
        _stored30 = from.Stored30;
        _offset = from.Offset;
        _offsetE = from.OffsetE;
        _modeStack = from.ModeStack;
        _namedStates = from.NamedStates;
        Modes();
    }
}
