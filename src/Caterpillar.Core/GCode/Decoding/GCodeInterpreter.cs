namespace Caterpillar.GCode;

/// <summary>Second half of decoding: executes the lines on a machine.</summary>
internal sealed class GCodeInterpreter
{
    private const byte LastFastOp = 1;

    private readonly Machine _machine;
    private readonly ParsedLine _parsed = new();
    private readonly MotionCommands _motion;
    private readonly GCommands _commands;
    private readonly MachineCommands _machineCommands;
    private readonly ExtendedCommands _extended;

    public GCodeInterpreter(FlavorRules rules, ExtrusionRule rule, ExtrusionAxis axis)
    {
        _machine = new Machine(rules, rule, axis);
        Comments = new CommentInterpreter(_machine);
        var extruder = new ExtruderWords(_machine);
        var positions = new PositionCommands(_machine, extruder);
        var modes = new ModeCommands(_machine, positions);
        var events = new EventCommands(_machine);
        _motion = new MotionCommands(_machine, extruder, modes);
        _commands = new GCommands(_machine, events, modes, positions, _motion);
        _machineCommands = new MachineCommands(_machine, modes, positions, events, Comments);
        _extended = new ExtendedCommands(_machine, modes, events, Comments);
    }

    /// <summary>The machine after the lines so far.</summary>
    public Machine Machine => _machine;

    public CommentInterpreter Comments { get; }

    /// <summary>The state of the machine. It changes with the next line. <see cref="Save"/> copies it.</summary>
    public InterpreterState State => _machine.State;

    /// <summary>Moves of the last line that was read by <see cref="ReadLine(ParsedLine, byte[], int, out int)"/>.</summary>
    public ToolpathColumns LastMoves => _machine.Moves.Columns;

    /// <summary>Events of the last line.</summary>
    public IReadOnlyList<MoveEvent> LastEvents => _machine.Moves.Events;

    /// <summary>The arc of the last line, if any.</summary>
    public Arc? LastArc => _machine.Moves.LastArc;

    /// <summary>True if G1 to G3 print without E.</summary>
    public bool PrintsWithoutE => _machine.Moves.PrintsWithoutE;

    /// <summary>Executes the lines of a chunk, after <paramref name="firstLine"/> earlier lines.</summary>
    [MethodImpl(Compile.Optimized)]
    public void Run(ChunkParser chunk, int firstLine)
    {
        var text = chunk.Chunk!.Text;
        var records = chunk.Records;
        var count = chunk.Count;
        var diagnostics = _machine.Diagnostics;
        var state = _machine.State;
        var moves = _machine.Moves;
        _machine.Features.Add(Feature.Lines, count);
        _machine.Features.Add(Feature.CrLf, chunk.CrLf);
        _machine.Features.Add(Feature.SemicolonComments, chunk.Comments);
        var others = 0;
        for (var i = 0; i < count; i++)
        {
            ref var record = ref records[i];
            diagnostics.Line = firstLine + i + 1;
            if (record.Op > LastFastOp)
            {
                others++;
                if (record.Op == ChunkParser.Comment) CommentLine(text, record.Start, record.Aux);
                else Execute(text, record.Start, record.Aux);
                continue;
            }
            if (record.Aux >= 0 && !Comments.HasRoles) Comments.AfterMove(text, record.Aux);
            int mask = record.Mask;
            state.Modes.Motion = record.Op;
            if ((mask & ChunkParser.HasF) != 0) _machine.SetFeed(record.F);
            _motion.Line(mask, record.X, record.Y, record.Z, record.E, record.Op);
            if (state.Modes.IsPlain) i = moves.Extrusions(records, i + 1, count, firstLine) - 1;
        }
        _machine.Counters.Commands += count - others;
    }

    /// <summary>
    /// Reads a line, forgets the moves before it and returns the number of its moves. <paramref name="commands"/> counts motion commands, with or without
    /// moves.
    /// </summary>
    public int ReadLine(byte[] text, int start, int end, out int commands)
    {
        _parsed.Scan(text, start, end);
        return ReadLine(_parsed, text, end, out commands);
    }

    /// <summary>The same for a line whose words are known.</summary>
    public int ReadLine(ParsedLine line, byte[] text, int end, out int commands)
    {
        _machine.Moves.Clear();
        var counters = _machine.Counters;
        var before = counters.Rapids + counters.Feeds;
        Execute(line, text, end);
        commands = counters.Rapids + counters.Feeds - before;
        return LastMoves.Count;
    }

    /// <inheritdoc cref="Machine.Save"/>
    public InterpreterState Save(InterpreterState? copy = null) => _machine.Save(copy ?? new InterpreterState());

    public void Restore(InterpreterState saved) => _machine.Restore(saved);

    /// <summary>The finished toolpath, with the mm³ per unit of E of each tool.</summary>
    public Toolpath ToToolpath(double?[] volumePerE)
    {
        var tools = new ToolpathTool[_machine.Extruders.Count];
        for (var i = 0; i < tools.Length; i++)
        {
            var known = volumePerE.Length == 0 ? null : volumePerE[Math.Min(i, volumePerE.Length - 1)];
            tools[i] = new ToolpathTool(State.Modes.Volumetric ? 1 : known);
        }
        return _machine.Moves.ToToolpath(tools);
    }

    private void CommentLine(byte[] text, int start, int end)
    {
        _machine.Features.Add(Feature.SemicolonComments);
        Comments.Line(text, start, end);
    }

    private void Execute(byte[] text, int start, int end)
    {
        if (_machine.Diagnostics.Line == 1 && start == 0) start = Files.ByteOrderMark.LengthAt(text, start, end);
        _parsed.Scan(text, start, end);
        Execute(_parsed, text, end);
    }

    private void Execute(ParsedLine line, byte[] text, int end)
    {
        _machine.Features.Count(line);
        if (line.Shape == LineShape.Macro)
        {
            _extended.Take(text, line);
            return;
        }
        if (line.CommentStart >= 0)
        {
            if (line.Shape == LineShape.Empty) Comments.Line(text, line.CommentStart, end);
            else if (!Comments.HasRoles) Comments.AfterMove(text, line.CommentStart);
        }
        if (line.Shape == LineShape.Empty) return;
        if (line.HasValue[0] && line.Letters[0] is (byte)'G' or (byte)'M' or (byte)'T') _machine.Counters.Commands++;
        switch ((char)line.Letters[0])
        {
            case 'M':
                _machineCommands.Take(text, line);
                return;
            case 'T':
                _machine.Log.See(text, line.LetterAt[0], line.CodeEnd);
                if (!_machine.Rules.ToolByM6) _machine.ChangeTool(line.Values[0]);
                else State.NextTool = line.Values[0];
                return;
            case 'O':
                _machine.Log.See(text, line.LetterAt[0], line.CodeEnd);
                return;
            default:
                _commands.Take(text, line);
                return;
        }
    }
}
