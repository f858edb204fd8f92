namespace Caterpillar.GCode;

/// <summary>The machine that executes a file: the rules of its firmware, its state and its moves so far.</summary>
internal sealed class Machine
{
    public Machine(FlavorRules rules, ExtrusionRule rule, ExtrusionAxis axis)
    {
        Rules = rules;
        Axis = axis;
        State.Modes.Volumetric = rules.StartsVolumetric;
        State.Work.Selected = rules.WorkspacesByG92 ? 0 : 1;
        Extruders = new Extruders(rules, State, Counters);
        Moves = new MoveRecorder(this, rule);
        Log = new CommandLog(this);
        Extruders.Select(0);
    }

    public FlavorRules Rules { get; }

    /// <summary>The words that extrude.</summary>
    public ExtrusionAxis Axis { get; }

    public InterpreterState State { get; } = new();

    public LineDiagnostics Diagnostics { get; } = new();

    public DecodeCounters Counters { get; } = new();

    public Features Features { get; } = new();

    public CommandLog Log { get; }

    public Extruders Extruders { get; }

    public MoveRecorder Moves { get; }

    /// <summary>The last line that changed a mode.</summary>
    public int LastModeLine { get; private set; }

    /// <summary>Copies the state into another one, and returns that.</summary>
    public InterpreterState Save(InterpreterState copy)
    {
        copy.CopyFrom(State);
        copy.EByTool = Extruders.Positions();
        return copy;
    }

    public void Restore(InterpreterState saved)
    {
        Extruders.Restore(saved.EByTool, saved.Tool);
        State.CopyFrom(saved);
        ModesChanged();
    }

    /// <summary>After each change of a mode: which rule of E holds, and whether the fast path does.</summary>
    public void ModesChanged()
    {
        LastModeLine = Diagnostics.Line;
        ref var modes = ref State.Modes;
        ref var extrusion = ref State.Extrusion;
        modes.ResolveE(Rules.RelativeE);
        if (!extrusion.HasMarlin2E && modes.RelativeE != modes.LastRelative)
        {
            extrusion.HasMarlin2E = true;
            extrusion.Marlin2E = extrusion.E;
            Counters.EMarlin2 = Counters.ENet;
        }
        ResolvePlain();
    }

    /// <summary>The file states the position in some axes, and it is lost in others, both as a mask of <see cref="ChunkParser"/>.</summary>
    public void Restate(int stated, int lost = 0)
    {
        State.Head.Lost = (State.Head.Lost & ~stated) | lost;
        ResolvePlain();
    }

    private void ResolvePlain()
    {
        ref var modes = ref State.Modes;
        modes.IsPlain = !modes.Relative && !modes.Inches && !modes.IsRelativeEDisputed && !State.Extrusion.HasMarlin2E && State.Head.Lost == 0;
    }

    public void SetFeed(double feed)
    {
        feed *= State.Modes.Unit;
        if (feed is > 0 and < 1e9) State.Feed.Set(feed, State.Feed.Factor);
    }

    public void ChangeTool(double number)
    {
        if (!(number >= 0 && number < Rules.ToolLimit) || number != Math.Floor(number))
        {
            Log.Ignore();
            return;
        }
        var tool = (int)number;
        if (tool == State.Tool) return;
        Counters.ToolChanges++;
        Extruders.Change(tool);
        Moves.AddEvent(new ToolEvent(tool));
    }

    /// <summary>A tool number, or null if it is out of range.</summary>
    public int? ToolNumber(double number) => number >= 0 && number < Rules.ToolLimit ? (int)number : null;

    /// <summary>The position as written that the words of a line name.</summary>
    public Vec3 Target(ParsedLine line)
    {
        ref var head = ref State.Head;
        return new Vec3(
            line.TryGet('X', out var x) ? Target(head.X, x, head.ShiftX) : head.X,
            line.TryGet('Y', out var y) ? Target(head.Y, y, head.ShiftY) : head.Y,
            line.TryGet('Z', out var z) ? Target(head.Z, z, head.ShiftZ) : head.Z);
    }

    /// <summary>The same for one axis.</summary>
    public double Target(double from, double word, double shift)
    {
        word *= State.Modes.Unit;
        return State.Work.IsMachineLine ? word - shift : State.Modes.Relative ? from + word : word;
    }
}
