namespace Caterpillar.GCode;

/// <summary>
/// Writes a toolpath as new G-code, block by block: <see cref="WriteStart"/>, <see cref="WriteBlock"/> for each block in order, <see cref="WriteEnd"/>. After
/// the start G-code, it writes its modal state: G90, M82 or M83, and <c>G92 E0</c> for absolute E. Unchanged words and moves without words are left out,
/// compared by the written digits. Rounding errors of E carry over: the written sum of E differs from the sum of the moves by at most half the last decimal.
/// </summary>
internal sealed class GCodeWriter
{
    private GCodeFormat _format;
    private readonly FlavorRules _rules;
    private readonly LineBuffer _out;
    private readonly MotionLines _motion;
    private readonly RawEffects _raw;
    private readonly ObjectLabels _labels;
    private readonly bool _switches;
    private Toolpath _toolpath;
    private int _nextBlock;
    private int _nextEvent;
    private int _tool;
    private int _layer = -1;
    private int _layers;
    private Role _role = Role.Unspecified;
    private string _object = "";
    private HomeEvent? _homed;
    private bool _on;
    private double _travelSpeed;

    // The head may be elsewhere than the next move begins.
    private bool _positionLost;

    public GCodeWriter(Toolpath toolpath, GCodeFormat? format = null)
    {
        _toolpath = toolpath ?? throw new ArgumentNullException(nameof(toolpath));
        _format = format ?? new GCodeFormat(new Printer());
        _rules = _format.Flavor;
        _out = new LineBuffer();
        _motion = new MotionLines(_format, _out);
        _switches = _format.Switches;
        _raw = new RawEffects(_rules, _format.ExtruderLetter);
        _labels = new ObjectLabels(_format.LabelsObjects ? _rules.ObjectMarks : ObjectMarking.None);
    }

    /// <summary>Records the lines of each move, event and template. Null = off.</summary>
    public WrittenLines? Written { get; init; }

    /// <summary>Lines written so far.</summary>
    public long Lines => _out.Lines;

    /// <summary>Bytes written so far.</summary>
    public long Bytes { get; private set; }

    /// <summary>Writes all of a toolpath.</summary>
    /// <exception cref="ArgumentOutOfRangeException">A coordinate is not finite or too large to print.</exception>
    /// <exception cref="IOException">The stream cannot be written.</exception>
    /// <exception cref="OperationCanceledException">Canceled.</exception>
    public void WriteAll(Stream stream, IProgress<double>? progress = null, CancellationToken cancel = default, Stream? facts = null)
    {
        WriteStart(stream, facts);
        for (var i = 0; i < _toolpath.Blocks.Count; i++)
        {
            cancel.ThrowIfCancellationRequested();
            WriteBlock(stream, i);
            progress?.Report((i + 1.0) / _toolpath.Blocks.Count);
        }
        WriteEnd(stream);
    }

    /// <summary>Writes header, start G-code and modal state.</summary>
    /// <param name="stream">The file.</param>
    /// <param name="facts">Takes the lines that only the whole print tells, at their place in the file; null = the same stream.</param>
    public void WriteStart(Stream stream, Stream? facts = null)
    {
        foreach (var line in _format.Header) _out.Comment(" " + line);
        Flush(stream);
        foreach (var line in _format.Facts) _out.Line(line);
        Flush(facts ?? stream);
        Template(_format.Start);
        _raw.Read(_format.Start);
        _motion.StateUnits(_raw);
        _motion.StateModes();
        if (_raw.Tool is > 0) StateTool(_tool);
        Written?.EndStart(Lines);
        Flush(stream);
    }

    /// <summary>Writes the moves of a block and the events between them.</summary>
    /// <exception cref="InvalidOperationException">The block is not the next one.</exception>
    /// <inheritdoc cref="WriteAll" path="/exception"/>
    public void WriteBlock(Stream stream, int block)
    {
        if (block != _nextBlock) throw new InvalidOperationException("Write the blocks of a toolpath in order.");
        _nextBlock++;
        var columns = _toolpath.Blocks[block].Columns;
        var first = _toolpath.FirstOf(block);
        for (var i = 0; i < columns.Count; i++)
        {
            // The event of a dwell is the dwell: its layer and tool come first.
            if (columns.Kind[i] == MoveKind.Dwell && columns.Layer[i] != _layer) Layer(columns.Layer[i]);
            Events(first + i);
            Move(columns, block, i);
            Written?.EndMove(first + i, Lines);
            if (_out.Count > 1 << 20) Flush(stream);
        }
        Flush(stream);
    }

    /// <summary>Continues with a longer toolpath that begins like the one so far, and with a format that may have new end G-code.</summary>
    public void GoOn(Toolpath longer, GCodeFormat format) => (_toolpath, _format) = (longer, format);

    /// <summary>Writes the events after the last move and the end G-code.</summary>
    public void WriteEnd(Stream stream)
    {
        if (_nextBlock != _toolpath.Blocks.Count) throw new InvalidOperationException("Write all blocks before the end.");
        Events(_toolpath.Count);
        if (_on) Switch(false);
        Object("");
        if (_format.End.Count > 0) _motion.SetRelative(false);
        Written?.BeginEnd(Lines);
        Template(_format.End);
        Flush(stream);
    }

    // Purge lines and whatever else the start and end code do are not part of the print.
    private void Template(IReadOnlyList<string> lines)
    {
        if (lines.Count == 0) return;
        _role = Role.Purge;
        _out.Comment("TYPE:" + RoleNames.Of(_role));
        foreach (var line in lines) _out.Line(line);
    }

    private void Flush(Stream stream)
    {
        Bytes += _out.Count;
        _out.FlushTo(stream);
    }

    private void Move(ToolpathColumns c, int block, int i)
    {
        if (c.Layer[i] != _layer) Layer(c.Layer[i]);
        if (c.Tool[i] != _tool) Tool(c.Tool[i]);
        Written?.BeginMove(_toolpath.FirstOf(block) + i, Lines);
        var kind = c.Kind[i];
        var home = _homed;
        _homed = null;
        // The home command has made this move already.
        if (home is not null && kind == MoveKind.Travel && new Vec3(c.X[i], c.Y[i], c.Z[i]) == home.Home(StartOf(c, block, i))) return;
        switch (kind)
        {
            case MoveKind.Dwell:
                return;
            case MoveKind.Retract or MoveKind.Deretract:
                if (_rules.FirmwareRetraction && (_format.Printer.FirmwareRetraction || c.E[i] == 0))
                {
                    _out.Command((byte)'G', kind == MoveKind.Retract ? 10 : 11);
                    _out.EndLine();
                    return;
                }
                break;
            case MoveKind.Print:
            case MoveKind.Prime when _role == Role.Purge:
                if (c.Role[i] != _role)
                {
                    _role = c.Role[i];
                    _out.Comment("TYPE:" + RoleNames.Of(_role));
                }
                break;
        }
        if (_switches) Switch(kind == MoveKind.Print);
        ReturnTo(c, block, i);
        if (kind == MoveKind.Travel) _travelSpeed = c.Speed[i];
        _motion.Rotary.Aim(c, i);
        var code = kind == MoveKind.Travel ? 0 : 1;
        if (c.TryGetArc(i, out var arc)) _motion.Arc(StartOf(c, block, i), new Vec3(c.X[i], c.Y[i], c.Z[i]), c.E[i], c.Speed[i], arc, code);
        else _motion.Straight(c.X[i], c.Y[i], c.Z[i], c.E[i], c.Speed[i], code);
    }

    // Firmware without amounts: the extruder is on or off.
    private void Switch(bool on)
    {
        if (on == _on) return;
        _on = on;
        _out.Command((byte)'M', on ? 101 : 103);
        _out.EndLine();
    }

    private void Events(int move)
    {
        var events = _toolpath.Events;
        for (; _nextEvent < events.Count && events[_nextEvent].Move <= move; _nextEvent++)
        {
            var before = Lines;
            Event(events[_nextEvent].Event);
            Written?.Event(_nextEvent, before, Lines);
        }
    }

    private void Event(PrinterEvent what)
    {
        switch (what)
        {
            case ToolEvent tool:
                Tool(tool.Tool);
                return;
            case RawEvent raw:
                Raw([raw.Line]);
                return;
            case HomeEvent home:
                _homed = home;
                _motion.ForgetPosition();
                break;
        }
        foreach (var line in EventText.Lines(what, _rules)) _out.Line(line);
    }

    private void Tool(int tool)
    {
        if (tool == _tool) return;
        var lines = _format.ToolLines?.Invoke(_tool, tool);
        _motion.Extruder.Leave(_tool, tool);
        _tool = tool;
        if (lines is { Count: > 0 }) RawOutside(lines);
        else StateTool(tool);
        _motion.Extruder.Enter(tool);
    }

    private void StateTool(int tool) => _out.Line(EventText.Tool(tool, _rules));

    private void Layer(int number)
    {
        var before = _layer >= 0 ? _toolpath.Layers[_layer] : null;
        _layer = number;
        if (number < 0)
        {
            Object("");
            return;
        }
        var layer = _toolpath.Layers[number];
        if (before is null || layer.Index != before.Index || layer.Z != before.Z)
        {
            _motion.Extruder.BeginLayer();
            _out.Comment("LAYER_CHANGE");
            _out.Comment("Z:" + NumberFormatter.Format(layer.Z, 4));
            if (layer.Thickness > 0) _out.Comment("HEIGHT:" + NumberFormatter.Format(layer.Thickness, 4));
            if (_layers++ > 0 && _format.LayerLines?.Invoke(layer) is { Count: > 0 } lines) RawOutside(lines);
        }
        Object(layer.Object);
    }

    private void Object(string name)
    {
        if (name == _object) return;
        if (_object.Length > 0)
        {
            if (_labels.LacksNames) _out.Comment(" stop printing object " + _object);
            foreach (var line in _labels.End(_labels.NumberOf(_object))) _out.Line(line);
        }
        _object = name;
        if (name.Length > 0)
        {
            foreach (var line in _labels.Start(_labels.NumberOf(name))) _out.Line(line);
            if (_labels.LacksNames) _out.Comment(" printing object " + name);
        }
        // Absolute E would extrude after an object that was canceled what was left out of it.
        if (_format.LabelsObjects && _rules.ObjectMarks != ObjectMarking.None) _motion.Extruder.Reset();
    }

    // Of a canceled object the firmware skips all moves, those of templates, too.
    private void RawOutside(IReadOnlyList<string> lines)
    {
        var name = _object;
        if (_format.LabelsObjects) Object("");
        Raw(lines);
        Object(name);
    }

    private void Raw(IReadOnlyList<string> lines)
    {
        // Lines from elsewhere may count on absolute positions.
        _motion.SetRelative(false);
        foreach (var line in lines) _out.Line(line);
        Restate(lines);
    }

    // After lines from elsewhere what they may have changed. The next move states its whole position and its speed.
    private void Restate(IReadOnlyList<string> lines)
    {
        _raw.Read(lines);
        if (_raw.Switch is { } on) _on = on;
        _motion.StateUnits(_raw);
        if (_raw.Modes || _raw.E) _motion.StateModes();
        if (_raw.Tool is { } tool && tool != _tool) StateTool(_tool);
        if (!_raw.Position && !_raw.Unit) return;
        _positionLost |= _motion.KnowsPosition;
        _motion.ForgetPosition();
        _motion.ForgetSpeed();
    }

    // Extrusions begin where the path does, not where lines from elsewhere have left the head.
    private void ReturnTo(ToolpathColumns c, int block, int i)
    {
        if (!_positionLost) return;
        _positionLost = false;
        if (c.Kind[i] is MoveKind.Travel or MoveKind.Dwell) return;
        var start = StartOf(c, block, i);
        _motion.Straight(start.X, start.Y, start.Z, 0, _travelSpeed > 0 ? _travelSpeed : c.Speed[i], 0);
    }

    private Vec3 StartOf(ToolpathColumns c, int block, int i)
        => i > 0 ? new Vec3(c.X[i - 1], c.Y[i - 1], c.Z[i - 1]) : _toolpath.StartOf(block);
}
